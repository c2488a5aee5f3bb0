package org.selectiverenderer.runtime.instance;

import java.util.List;
import org.jspecify.annotations.Nullable;

/**
 * What a surface has that most have not: several textures, a back of its own, a physical material.
 * Such surfaces are lit at their pixels.
 *
 * @param units the textures
 * @param stages of the units that are stages, in their order
 * @param numbers {@link #NUMBERS} of them: metallic, roughness, scale of the normal texture,
 *     strength of the occlusion; r, g, b, a of a MultiTexture; least opacity that is drawn, 0, 0, 0
 * @param back the surface of the back, or null when it looks like the front; its textures are the
 *     front's
 */
public record SurfaceDetail(
    boolean physical,
    List<TextureUnit> units,
    List<TextureStage> stages,
    float[] numbers,
    @Nullable Surface back,
    AlphaMode alphaMode) {
  /** How many {@code numbers} there are. */
  public static final int NUMBERS = 12;

  /** Textures of one surface: what every card has, less one for others. */
  public static final int MOST_UNITS = 15;

  /** What is done with opacity (X3D 4.0, 12.4.2). */
  public enum AlphaMode {
    AUTO,
    OPAQUE,
    MASK,
    BLEND
  }
}
