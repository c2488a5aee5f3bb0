package org.selectiverenderer.polygon;

import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.math.BigDecimal;
import java.math.RoundingMode;
import org.selectiverenderer.formats.json.JsonTree;
import org.selectiverenderer.formats.json.JsonWriter;
import org.selectiverenderer.polygon.SceneStatistics.ObjectCount;
import org.selectiverenderer.polygon.SceneStatistics.ScopeCount;
import org.selectiverenderer.polygon.SceneStatistics.StateCount;

/**
 * Writes polygon counts as JSON. Percentages have two decimals; the scope of an object may be null.
 */
public final class SceneStatisticsJsonWriter {
  private SceneStatisticsJsonWriter() {}

  /** Returns the JSON text; its last line is terminated. */
  public static String of(SceneStatistics statistics) {
    ObjectNode json = JsonTree.object();
    json.put("scene", statistics.scene()).put("total_high", statistics.totalHigh());
    ArrayNode objects = json.putArray("objects");
    for (ObjectCount count : statistics.objects()) {
      ObjectNode object = objects.addObject();
      object.put("switch", count.switchName()).put("scope", count.scope().orElse(null));
      count.versions().forEach(object.putArray("versions")::add);
    }
    ArrayNode scopes = json.putArray("scopes");
    for (ScopeCount count : statistics.scopes()) {
      ObjectNode scope = scopes.addObject().put("scope", count.scope()).put("high", count.high());
      ArrayNode states = scope.putArray("states");
      for (StateCount state : count.states()) {
        ObjectNode object = states.addObject();
        state.schemas().forEach(object.putArray("schemas")::add);
        object.put("polygons", state.polygons()).put("percent", rounded(state.percent()));
        cost(object, state.cost(), "");
      }
      cost(scope, count.highCost(), "high_");
    }
    return JsonWriter.of(json);
  }

  private static void cost(ObjectNode object, RenderingCost cost, String prefix) {
    object.put(prefix + "draw_calls", cost.drawCalls());
    object.put(prefix + "texture_bytes", cost.textureBytes());
  }

  private static double rounded(double percent) {
    return BigDecimal.valueOf(percent).setScale(2, RoundingMode.HALF_UP).doubleValue();
  }
}
