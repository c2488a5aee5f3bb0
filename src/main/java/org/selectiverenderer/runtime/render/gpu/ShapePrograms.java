package org.selectiverenderer.runtime.render.gpu;

import com.jogamp.opengl.GL3;
import java.util.HashMap;
import java.util.Map;

/** The shape programs made so far, one per variant. */
public final class ShapePrograms {
  private final Map<ShapeVariant, ShapeProgram> programs = new HashMap<>();

  public ShapeProgram get(GL3 gl, ShapeVariant variant) {
    return programs.computeIfAbsent(variant, missing -> new ShapeProgram(gl, missing));
  }

  public void dispose(GL3 gl) {
    programs.values().forEach(program -> program.dispose(gl));
    programs.clear();
  }
}
