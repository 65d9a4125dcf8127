"""libusb's functions that find, open and claim devices."""

import ctypes
from typing import Any

from kinect.usb.simulated_descriptors import config_descriptor, device_descriptor
from kinect.usb.simulated_devices import ERROR_ACCESS, ERROR_BUSY, ERROR_NO_DEVICE, ERROR_NOT_FOUND
from kinect.usb.simulated_library import SimulatedLibrary, number_of


class BusCalls(SimulatedLibrary):
    """Named and called as in libusb.h."""

    def libusb_set_debug(self, context: Any, level: int) -> None:
        """Nothing to tell."""

    def libusb_init(self, context: Any) -> int:
        assert self.next_host is not None
        context._obj.value = next(self._numbers)
        self.contexts[context._obj.value] = self.next_host
        return 0

    def libusb_exit(self, context: Any) -> None:
        self.contexts.pop(number_of(context), None)

    def libusb_get_device_list(self, context: Any, out: Any) -> int:
        host = self.contexts[number_of(context)]
        with host.lock:
            host.dispatch()
            devices = list(host.devices)
        numbers = [self.device_number(host, device) for device in devices]
        if numbers:
            array = (ctypes.c_void_p * len(numbers))(*numbers)
            out._obj.contents = ctypes.c_void_p.from_buffer(array)
            self._lists[ctypes.addressof(array)] = (array, numbers)
            for number in numbers:
                self.references[number] += 1
        return len(numbers)

    def libusb_free_device_list(self, devices: Any, unreference: int) -> None:
        _, numbers = self._lists.pop(ctypes.cast(devices, ctypes.c_void_p).value or 0, (None, []))
        for number in numbers if unreference else []:
            self.references[number] -= 1

    def libusb_get_parent(self, device: Any) -> int | None:
        return None

    def libusb_ref_device(self, device: Any) -> int:
        self.references[number_of(device)] += 1
        return number_of(device)

    def libusb_unref_device(self, device: Any) -> None:
        self.references[number_of(device)] -= 1

    def libusb_get_device_descriptor(self, device: Any, out: Any) -> int:
        device_descriptor(out._obj, self.known[number_of(device)][1])
        return 0

    def libusb_get_config_descriptor(self, device: Any, index: int, out: Any) -> int:
        number = number_of(device)
        if number not in self._configurations:
            self._configurations[number] = config_descriptor(self.module, self.known[number][1])
        out._obj.contents = self._configurations[number]
        return 0

    def libusb_free_config_descriptor(self, descriptor: Any) -> None:
        """They live as long as the simulation."""

    def libusb_get_string_descriptor_ascii(self, *_: Any) -> int:
        return ERROR_NOT_FOUND

    def libusb_get_bus_number(self, device: Any) -> int:
        return self.known[number_of(device)][1].bus

    def libusb_get_device_address(self, device: Any) -> int:
        return self.known[number_of(device)][1].address

    def libusb_get_device_speed(self, device: Any) -> int:
        return 3

    def libusb_get_port_number(self, device: Any) -> int:
        return self.known[number_of(device)][1].ports[-1]

    def libusb_get_port_numbers(self, device: Any, out: Any, size: int) -> int:
        ports = self.known[number_of(device)][1].ports
        out[: len(ports)] = ports
        return len(ports)

    def libusb_open(self, device: Any, out: Any) -> int:
        host, opened = self.known[number_of(device)]
        if opened.gone:
            return ERROR_NO_DEVICE
        if opened.forbidden:
            return ERROR_ACCESS
        out._obj.value = next(self._numbers)
        self.handles[out._obj.value] = (host, opened)
        return 0

    def libusb_close(self, handle: Any) -> None:
        entry = self.handles.pop(number_of(handle), None)
        if entry is None:
            return
        host, device = entry
        if device.claimed_by == number_of(handle):
            device.claimed_by = None
        if any(s.device is device for s in host.submissions.values()):
            self.misuse.append("closed a handle while transfers were in flight on it")

    def libusb_set_configuration(self, handle: Any, value: int) -> int:
        self.misuse.append("set_configuration: it resets a Kinect's interfaces")
        return 0

    def libusb_get_configuration(self, handle: Any, out: Any) -> int:
        out._obj.value = 1
        return self.gone(handle)

    def libusb_claim_interface(self, handle: Any, interface: int) -> int:
        device = self.device_of(handle)
        if device is None or device.gone:
            return ERROR_NO_DEVICE
        if device.busy or device.kernel_driver or device.claimed_by not in (None, number_of(handle)):
            return ERROR_BUSY
        device.claimed_by = number_of(handle)
        return 0

    def libusb_release_interface(self, handle: Any, interface: int) -> int:
        device = self.device_of(handle)
        if device is None or device.gone:
            return ERROR_NO_DEVICE
        device.claimed_by = None
        return 0

    def libusb_set_interface_alt_setting(self, handle: Any, interface: int, setting: int) -> int:
        device = self.device_of(handle)
        if device is not None:
            device.setting = setting
        return self.gone(handle)

    def libusb_reset_device(self, handle: Any) -> int:
        self.misuse.append("reset a device: a Kinect's audio part does not survive that")
        return 0

    def libusb_kernel_driver_active(self, handle: Any, interface: int) -> int:
        device = self.device_of(handle)
        return self.gone(handle) or int(device is not None and device.kernel_driver)

    def libusb_detach_kernel_driver(self, handle: Any, interface: int) -> int:
        device = self.device_of(handle)
        if device is not None and not device.busy:
            device.kernel_driver = False
        return self.gone(handle)

    def libusb_attach_kernel_driver(self, handle: Any, interface: int) -> int:
        return self.gone(handle)

    def libusb_clear_halt(self, handle: Any, endpoint: int) -> int:
        return self.gone(handle)
