package org.selectiverenderer.render.gpu;

import com.jogamp.opengl.GL3;
import java.util.HashMap;
import java.util.Map;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;

/**
 * A cache of the variants of the shape shader: one per material variant, light counts and effects,
 * compiled when first needed.
 */
public final class ShapeProgramCache {
  private final Map<ShaderVariant, Family> families = new HashMap<>();
  private final ShaderSourceLoader texts = new ShaderSourceLoader();

  /** The programs of one material variant, which differ in their lights and effects. */
  public static final class Family {
    private final ShaderVariant variant;
    private final @Nullable Family front;
    private final ShaderSourceLoader texts;
    private final Map<LightCounts, ShapeProgram> byLights = new HashMap<>();
    private final Map<Scenic, ShapeProgram> scenic = new HashMap<>();

    private record Scenic(LightCounts lights, ShaderEffects scenery) {}

    private Family(ShaderVariant variant, @Nullable Family front, ShaderSourceLoader texts) {
      this.variant = variant;
      this.front = front;
      this.texts = texts;
    }

    /**
     * Returns the programs for views in which only front faces are seen, which compute no lighting
     * for back faces.
     */
    public Family front() {
      return front == null ? this : front;
    }

    /** Returns the program for these light counts, compiled when first asked for. */
    public ShapeProgram get(GL3 gl, LightCounts lights) {
      LightCounts counted = variant.lit() ? lights : LightCounts.NONE;
      return byLights.computeIfAbsent(
          counted, counts -> new ShapeProgram(gl, texts, variant, counts, ShaderEffects.NONE));
    }

    /** Returns the program for these light counts and effects, compiled when first asked for. */
    public ShapeProgram get(GL3 gl, LightCounts lights, ShaderEffects scenery) {
      if (scenery == ShaderEffects.NONE) {
        return get(gl, lights);
      }
      LightCounts counted = variant.lit() ? lights : LightCounts.NONE;
      return scenic.computeIfAbsent(
          new Scenic(counted, scenery),
          key -> new ShapeProgram(gl, texts, variant, key.lights(), key.scenery()));
    }

    private Stream<ShapeProgram> programs() {
      return Stream.concat(byLights.values().stream(), scenic.values().stream());
    }
  }

  public Family get(ShaderVariant variant) {
    Family known = families.get(variant);
    if (known == null) {
      ShaderVariant front = variant.front();
      known = new Family(variant, front.equals(variant) ? null : get(front), texts);
      families.put(variant, known);
    }
    return known;
  }

  /**
   * Returns the programs of the same material variant for batches with a diffuse colour per vertex.
   */
  public Family tinted(Family family) {
    return get(family.variant.tints());
  }

  public void dispose(GL3 gl) {
    families.values().stream().flatMap(Family::programs).forEach(program -> program.dispose(gl));
    families.clear();
  }
}
