package org.selectiverenderer.runtime.render.draw;

import com.jogamp.opengl.GL3;
import java.util.HashMap;
import java.util.HashSet;
import java.util.Map;
import java.util.Set;
import org.selectiverenderer.runtime.instance.CubeTexture;
import org.selectiverenderer.runtime.render.gpu.GpuTexture;
import org.selectiverenderer.runtime.render.gpu.TextureFilters;

/**
 * The environment maps that surfaces reflect, on the graphics card; each is kept as long as every
 * frame uses it. Belongs to the thread that owns the context.
 */
final class MirroredImages {
  private final Map<CubeTexture, GpuTexture> known = new HashMap<>();
  private final Set<CubeTexture> used = new HashSet<>();

  GpuTexture of(GL3 gl, CubeTexture image) {
    used.add(image);
    return known.computeIfAbsent(image, wanted -> new GpuTexture(gl, wanted, TextureFilters.FINE));
  }

  /** Frees the environment maps that were not used since the last call. */
  void forgetOthers(GL3 gl) {
    if (known.isEmpty()) {
      return;
    }
    known
        .entrySet()
        .removeIf(
            entry -> {
              boolean unused = !used.contains(entry.getKey());
              if (unused) {
                entry.getValue().dispose(gl);
              }
              return unused;
            });
    used.clear();
  }
}
