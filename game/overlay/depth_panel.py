"""The panel at the lower left: what the depth camera sees, as it sees it."""

import numpy as np
from imgui_bundle import ImVec2, imgui
from numpy.typing import NDArray

from game.overlay.docked import begin_docked
from game.overlay.layout import depth_area
from game.overlay.style import Fonts
from game.overlay.view import Shown, View


class DepthPanel:
    """Keeps one picture on the graphics card and sends it anew when it has changed."""

    def __init__(self, fonts: Fonts) -> None:
        self._fonts = fonts
        self._texture: imgui.ImTextureData | None = None
        self._sent: NDArray[np.uint8] | None = None
        self.uploads = 0

    def draw(self, view: View, shown: Shown, size: tuple[float, float]) -> None:
        """On a screen of `size` overlay units, where the view has a depth picture."""
        picture = view.depth_picture
        if picture is None or not shown.hud:
            return
        self._send(picture)
        assert self._texture is not None
        em = imgui.get_style().font_size_base * imgui.get_style().font_scale_dpi
        begin_docked("depth", depth_area(shown, size, em))
        imgui.push_font(self._fonts.strong, 0.9 * imgui.get_style().font_size_base)
        imgui.text("What the depth camera sees")
        imgui.pop_font()
        room = imgui.get_content_region_avail()
        height, width = picture.shape[:2]
        scale = min(room.x / width, room.y / height)
        imgui.image(self._texture.get_tex_ref(), ImVec2(scale * width, scale * height))
        imgui.end()

    def close(self) -> None:
        """Give the picture back; Dear ImGui's back end must still be there."""
        if self._texture is not None:
            imgui.internal.unregister_user_texture(self._texture)
            self._texture = None

    def _send(self, picture: NDArray[np.uint8]) -> None:
        """The picture (h, w, 4) into the texture, whose size it keeps for good."""
        if self._sent is not None and (picture is self._sent or np.array_equal(picture, self._sent)):
            return
        height, width = picture.shape[:2]
        texture = self._texture
        if texture is None:
            self._texture = texture = imgui.ImTextureData()
            texture.create(imgui.ImTextureFormat.rgba32, width, height)
            imgui.internal.register_user_texture(texture)
        pixels = np.asarray(texture.get_pixels_array()).reshape(-1)
        pixels[:] = picture.reshape(-1)
        if texture.status != imgui.ImTextureStatus.want_create:
            _queue(texture, width, height)
        self._sent = picture
        self.uploads += 1


def _queue(texture: imgui.ImTextureData, width: int, height: int) -> None:
    imgui.internal.im_texture_data_queue_upload(texture, 0, 0, width, height)
