package org.selectiverenderer.render.gpu;

import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.jspecify.annotations.Nullable;

/**
 * The number of lights of each kind that a program computes; its uniform array has them in this
 * order.
 *
 * @param directional directional lights
 * @param points point lights
 * @param spots spot lights
 */
public record LightCounts(int directional, int points, int spots) {
  /** No lights, for unlit shapes. */
  static final LightCounts NONE = new LightCounts(0, 0, 0);

  int all() {
    return directional + points + spots;
  }

  boolean positional() {
    return points + spots > 0;
  }

  List<String> defines() {
    String each =
        IntStream.range(0, all())
            .mapToObj(i -> kind(i) + "(" + i + ")")
            .collect(Collectors.joining(" "));
    return List.of("LIGHTS " + all(), "EACH_LIGHT " + each);
  }

  private String kind(int i) {
    return i < directional ? "DIRECTIONAL" : i < directional + points ? "POINT" : "SPOT";
  }

  // Written out, as records link theirs when first called: the first frame would wait for it.
  @Override
  public boolean equals(@Nullable Object other) {
    return other instanceof LightCounts one
        && directional == one.directional
        && points == one.points
        && spots == one.spots;
  }

  @Override
  public int hashCode() {
    return 31 * (31 * directional + points) + spots;
  }
}
