package org.selectiverenderer.browser.instance;

import java.util.List;
import org.jspecify.annotations.Nullable;

/**
 * The properties of a material that most materials lack: several textures, a different back side,
 * physically based shading. Such surfaces are lit per pixel.
 *
 * @param units the textures
 * @param stages the blending of the units that are MultiTexture stages, in their order
 * @param numbers the {@link #NUMBERS} shader parameters: metallic, roughness, normal scale,
 *     occlusion strength; r, g, b, a of a MultiTexture; alpha cutoff, 0, 0, 0
 * @param back the material of the back, or null if it is that of the front; both share the textures
 */
public record ExtendedMaterial(
    boolean physical,
    List<TextureUnit> units,
    List<TextureStage> stages,
    float[] numbers,
    @Nullable SurfaceMaterial back,
    AlphaMode alphaMode) {
  /** The length of {@code numbers}. */
  public static final int NUMBERS = 12;

  /**
   * Largest number of textures of a surface: the 16 units that every GPU has, less one for other
   * purposes.
   */
  public static final int MOST_UNITS = 15;

  /** The alpha mode of an Appearance (X3D 4.0, 12.4.2). */
  public enum AlphaMode {
    AUTO,
    OPAQUE,
    MASK,
    BLEND
  }
}
