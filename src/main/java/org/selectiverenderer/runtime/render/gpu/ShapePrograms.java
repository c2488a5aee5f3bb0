package org.selectiverenderer.runtime.render.gpu;

import com.jogamp.opengl.GL3;
import java.util.Arrays;
import java.util.HashMap;
import java.util.Map;
import java.util.Objects;
import org.jspecify.annotations.Nullable;

/** The shape programs made so far: one per variant and number of lights. */
public final class ShapePrograms {
  private final Map<ShapeVariant, Family> families = new HashMap<>();

  /** The programs of one variant, which differ in the number of lights. */
  public static final class Family {
    private final ShapeVariant variant;
    private final @Nullable ShapeProgram[] byLights = new ShapeProgram[ShapeProgram.MAX_LIGHTS + 1];

    private Family(ShapeVariant variant) {
      this.variant = variant;
    }

    /**
     * The program for so many lights, made when first asked for.
     *
     * @param lights 0 .. {@link ShapeProgram#MAX_LIGHTS}
     */
    public ShapeProgram get(GL3 gl, int lights) {
      int counted = variant.lit() ? lights : 0;
      ShapeProgram program = byLights[counted];
      if (program == null) {
        program = new ShapeProgram(gl, variant, counted);
        byLights[counted] = program;
      }
      return program;
    }
  }

  public Family get(ShapeVariant variant) {
    return families.computeIfAbsent(variant, Family::new);
  }

  public void dispose(GL3 gl) {
    families.values().stream()
        .flatMap(family -> Arrays.stream(family.byLights))
        .filter(Objects::nonNull)
        .forEach(program -> program.dispose(gl));
    families.clear();
  }
}
