package org.selectiverenderer.render.gpu;

import com.jogamp.opengl.GL3;
import java.util.List;
import org.jspecify.annotations.Nullable;

/**
 * The textures and uniform values of a surface with several textures. Compared by identity.
 *
 * @param textures one per texture unit
 * @param matrices texture transforms, sixteen numbers per unit
 * @param numbers twelve uniform values, as the shader declares them
 * @param back the back material, twelve numbers, or null
 * @param holes whether pixels are discarded where an image is transparent
 */
public record MaterialBinding(
    List<GpuTexture> textures,
    float[] matrices,
    float[] numbers,
    float @Nullable [] back,
    boolean holes) {

  /** Makes the textures current. */
  public void bind(GL3 gl) {
    for (int i = textures.size() - 1; i >= 0; i--) {
      textures.get(i).bind(gl, i);
    }
  }
}
