package org.selectiverenderer.runtime.render.gpu;

import com.jogamp.opengl.GL3;
import java.util.HashMap;
import java.util.Map;

/** The shape programs made so far: one per variant and kinds of lights. */
public final class ShapePrograms {
  private final Map<ShapeVariant, Family> families = new HashMap<>();

  /** The programs of one variant, which differ in their lights. */
  public static final class Family {
    private final ShapeVariant variant;
    private final Map<LightCounts, ShapeProgram> byLights = new HashMap<>();

    private Family(ShapeVariant variant) {
      this.variant = variant;
    }

    /** The program for such lights, made when first asked for. */
    public ShapeProgram get(GL3 gl, LightCounts lights) {
      LightCounts counted = variant.lit() ? lights : LightCounts.NONE;
      return byLights.computeIfAbsent(counted, counts -> new ShapeProgram(gl, variant, counts));
    }
  }

  public Family get(ShapeVariant variant) {
    return families.computeIfAbsent(variant, Family::new);
  }

  public void dispose(GL3 gl) {
    families.values().stream()
        .flatMap(family -> family.byLights.values().stream())
        .forEach(program -> program.dispose(gl));
    families.clear();
  }
}
