"""A simulated device's descriptors as the C structures that pyusb reads."""

from ctypes import Array, pointer
from typing import Any

from kinect.usb.simulated_devices import SimulatedDevice


def device_descriptor(descriptor: Any, device: SimulatedDevice) -> None:
    """Fill pyusb's structure in."""
    descriptor.bLength, descriptor.bDescriptorType, descriptor.bcdUSB = 18, 1, 0x0200
    descriptor.bDeviceClass, descriptor.bMaxPacketSize0 = device.device_class, 64
    descriptor.idVendor, descriptor.idProduct, descriptor.bcdDevice = device.vendor, device.product, device.release
    descriptor.bNumConfigurations = 1


def config_descriptor(module: Any, device: SimulatedDevice) -> Any:
    """One configuration with one interface in all its alternate settings; keeps alive what it points to. `module`: pyusb's libusb1."""
    settings = (module._libusb_interface_descriptor * len(device.settings))()
    keep: list[Array[Any]] = [settings]
    for number, endpoints in enumerate(device.settings):
        setting = settings[number]
        setting.bLength, setting.bDescriptorType = 9, 4
        setting.bInterfaceNumber, setting.bAlternateSetting = 0, number
        setting.bNumEndpoints, setting.bInterfaceClass = len(endpoints), 0xFF
        if endpoints:
            table = (module._libusb_endpoint_descriptor * len(endpoints))()
            for entry, (address, kind, size) in zip(table, endpoints):
                entry.bLength, entry.bDescriptorType, entry.bEndpointAddress = 7, 5, address
                entry.bmAttributes, entry.wMaxPacketSize, entry.bInterval = kind, size, 1
            setting.endpoint = table
            keep.append(table)
    interface = module._libusb_interface(settings, len(device.settings))
    configuration = module._libusb_config_descriptor()
    configuration.bLength, configuration.bDescriptorType, configuration.wTotalLength = 9, 2, 32
    configuration.bNumInterfaces, configuration.bConfigurationValue = 1, 1
    configuration.bmAttributes, configuration.bMaxPower = 0xC0, 8
    configuration.interface = pointer(interface)
    configuration.kept = (keep, interface)
    return configuration
