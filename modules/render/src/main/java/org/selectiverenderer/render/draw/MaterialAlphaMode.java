package org.selectiverenderer.render.draw;

import java.util.List;
import org.selectiverenderer.browser.instance.ExtendedMaterial;
import org.selectiverenderer.browser.instance.SurfaceMaterial;
import org.selectiverenderer.browser.instance.TextureStage;
import org.selectiverenderer.browser.instance.TextureUnit;
import org.selectiverenderer.render.gpu.GpuTexture;

/**
 * Interprets the opacity of a surface with several textures (X3D 4.0, 12.4.2: {@code alphaMode}).
 */
final class MaterialAlphaMode {
  private MaterialAlphaMode() {}

  /** Returns whether the surface is blended over what is behind it. */
  static boolean blended(
      SurfaceMaterial surface,
      ExtendedMaterial detail,
      List<GpuTexture> images,
      boolean translucentColors) {
    return switch (detail.alphaMode()) {
      case BLEND -> true;
      case OPAQUE, MASK -> false;
      case AUTO ->
          surface.transparency() > 0
              || translucentColors
              || (detail.back() != null && detail.back().transparency() > 0)
              || any(detail, images, GpuTexture.Alpha.BLENDED)
              || (detail.numbers()[7] < 1
                  && detail.stages().stream().map(TextureStage::source).anyMatch("FACTOR"::equals));
    };
  }

  /** Returns whether pixels are discarded where an image is transparent. */
  static boolean cutOut(ExtendedMaterial detail, List<GpuTexture> images) {
    return detail.alphaMode() == ExtendedMaterial.AlphaMode.AUTO
        && any(detail, images, GpuTexture.Alpha.CUT_OUT)
        && !any(detail, images, GpuTexture.Alpha.BLENDED);
  }

  /**
   * Returns whether one of the images that determine the opacity has an alpha channel of that kind.
   */
  private static boolean any(
      ExtendedMaterial detail, List<GpuTexture> images, GpuTexture.Alpha alpha) {
    for (int i = 0; i < images.size(); i++) {
      TextureUnit.Role role = detail.units().get(i).role();
      boolean covers =
          role == TextureUnit.Role.MAIN
              || role == TextureUnit.Role.DIFFUSE
              || role == TextureUnit.Role.STAGE;
      if (covers && images.get(i).alpha() == alpha) {
        return true;
      }
    }
    return false;
  }
}
