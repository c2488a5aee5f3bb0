package org.selectiverenderer.validation;

import java.util.function.ToLongFunction;
import org.selectiverenderer.polygon.EnrichmentPolygonModel.State;

/** What a budget can limit. */
public enum CostKind {
  /** The number of polygons. */
  POLYGONS("polygons", "polygons", State::polygons),
  /** The bytes of decoded pictures, with mip maps. */
  TEXTURE_BYTES("textureBytes", "bytes of textures", state -> state.cost().textureBytes()),
  /** The number of shapes that are drawn. */
  DRAW_CALLS("drawCalls", "draw calls", state -> state.cost().drawCalls());

  private final String key;
  private final String unit;
  private final ToLongFunction<State> count;

  CostKind(String key, String unit, ToLongFunction<State> count) {
    this.key = key;
    this.unit = unit;
    this.count = count;
  }

  /** Returns the key in a settings file. */
  public String key() {
    return key;
  }

  /** Returns the words after a number, for messages. */
  public String unit() {
    return unit;
  }

  /** Returns what a state costs. */
  public long of(State state) {
    return count.applyAsLong(state);
  }
}
