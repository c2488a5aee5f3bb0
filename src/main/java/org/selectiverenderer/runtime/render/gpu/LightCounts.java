package org.selectiverenderer.runtime.render.gpu;

import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.IntStream;

/**
 * The lights that a program computes, by kind; in its uniforms they stand in this order.
 *
 * @param directional lights that are everywhere alike
 * @param points lights with a position
 * @param spots lights with a position and a beam
 */
public record LightCounts(int directional, int points, int spots) {
  /** For what is not lit. */
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
}
