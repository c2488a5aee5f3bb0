package org.selectiverenderer.runtime.render.gpu;

import com.jogamp.opengl.GL3;
import java.util.HashMap;
import java.util.Map;
import org.jspecify.annotations.Nullable;

/** The shape programs made so far: one per variant and kinds of lights. */
public final class ShapePrograms {
  private final Map<ShapeVariant, Family> families = new HashMap<>();

  /** The programs of one variant, which differ in their lights. */
  public static final class Family {
    private final ShapeVariant variant;
    private final @Nullable Family front;
    private final Map<LightCounts, ShapeProgram> byLights = new HashMap<>();

    private Family(ShapeVariant variant, @Nullable Family front) {
      this.variant = variant;
      this.front = front;
    }

    /** The programs for where nothing but front sides is seen, which light no back. */
    public Family front() {
      return front == null ? this : front;
    }

    /** The program for such lights, made when first asked for. */
    public ShapeProgram get(GL3 gl, LightCounts lights) {
      LightCounts counted = variant.lit() ? lights : LightCounts.NONE;
      return byLights.computeIfAbsent(counted, counts -> new ShapeProgram(gl, variant, counts));
    }
  }

  public Family get(ShapeVariant variant) {
    Family known = families.get(variant);
    if (known == null) {
      ShapeVariant front = variant.front();
      known = new Family(variant, front.equals(variant) ? null : get(front));
      families.put(variant, known);
    }
    return known;
  }

  public void dispose(GL3 gl) {
    families.values().stream()
        .flatMap(family -> family.byLights.values().stream())
        .forEach(program -> program.dispose(gl));
    families.clear();
  }
}
