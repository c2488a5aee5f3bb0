package org.selectiverenderer.runtime.render.gpu;

import com.jogamp.opengl.GL3;
import java.util.List;
import org.jspecify.annotations.Nullable;

/**
 * What a program of detailed surfaces is told of one of them. Compared by identity.
 *
 * @param textures of its units
 * @param matrices sixteen numbers per unit
 * @param numbers twelve, as the shader says
 * @param back the material of the back, twelve numbers, or null
 * @param holes whether one sees through where an image has no pixels
 */
public record DetailTextures(
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
