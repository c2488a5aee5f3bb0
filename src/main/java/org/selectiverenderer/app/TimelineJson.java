package org.selectiverenderer.app;

import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ObjectNode;

/** The time line as JSON, one object per line, keys in the order that the command line promises. */
public final class TimelineJson {
  private final ObjectMapper mapper = new ObjectMapper();

  /** One line, without its end. */
  public String line(TimelineEvent event) {
    ObjectNode node = mapper.createObjectNode();
    if (event instanceof TimelineEvent.Start start) {
      head(node, start.t(), "start");
      ObjectNode switches = node.putObject("switches");
      start.switches().forEach(switches::put);
    } else if (event instanceof TimelineEvent.Enter enter) {
      head(node, enter.t(), "enter").put("sensor", enter.sensor());
      node.set("schemas", mapper.valueToTree(enter.schemas()));
    } else if (event instanceof TimelineEvent.Exit exit) {
      head(node, exit.t(), "exit").put("sensor", exit.sensor());
      node.set("schemas", mapper.valueToTree(exit.schemas()));
    } else if (event instanceof TimelineEvent.Switched switched) {
      head(node, switched.t(), "switch")
          .put("switch", switched.name())
          .put("from", switched.from())
          .put("to", switched.to())
          .put("schema", switched.schema());
    } else if (event instanceof TimelineEvent.End end) {
      head(node, end.t(), "end")
          .put("frames", end.frames())
          .putObject("polygons")
          .put("start", end.polygons().start())
          .put("end", end.polygons().end())
          .put("max", end.polygons().max());
    }
    return node.toString();
  }

  private static ObjectNode head(ObjectNode node, double t, String event) {
    return node.put("t", Math.round(t * 1e6) / 1e6).put("event", event);
  }
}
