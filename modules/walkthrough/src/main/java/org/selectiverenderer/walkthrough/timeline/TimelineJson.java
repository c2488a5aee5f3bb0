package org.selectiverenderer.walkthrough.timeline;

import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.Optional;
import org.selectiverenderer.base.decimal.DecimalRounding;
import org.selectiverenderer.control.ControlEvent;
import org.selectiverenderer.control.SwitchVisibility;
import org.selectiverenderer.formats.json.JsonTree;

/** Writes the time line as JSON, one object per line, with keys in the documented order. */
public final class TimelineJson {
  private final Optional<String> scene;

  /** Creates a writer for one scene. */
  public TimelineJson() {
    scene = Optional.empty();
  }

  /** Creates a writer for one of many scenes, whose lines begin with the key {@code scene}. */
  public TimelineJson(String scene) {
    this.scene = Optional.of(scene);
  }

  /** Returns the line of an event, without a line feed. */
  public String line(TimelineEvent event) {
    ObjectNode node = JsonTree.object();
    scene.ifPresent(name -> node.put("scene", name));
    node.put("t", DecimalRounding.to(6, event.t()));
    if (event instanceof TimelineEvent.ControllerEvent told) {
      put(node, told.event());
    } else if (event instanceof TimelineEvent.Headset headset) {
      node.put("event", "headset").put("what", headset.what());
    } else if (event instanceof TimelineEvent.End end) {
      node.put("event", "end")
          .put("frames", end.frames())
          .putObject("polygons")
          .put("start", end.polygons().start())
          .put("end", end.polygons().end())
          .put("max", end.polygons().max());
      if (!end.waiting().isEmpty()) {
        ObjectNode waiting = node.putObject("waiting");
        end.waiting().forEach(waiting::put);
      }
      if (!end.qualities().isEmpty()) {
        ObjectNode qualities = node.putObject("qualities");
        end.qualities().forEach(each -> put(qualities, each));
      }
    }
    return node.toString();
  }

  private void put(ObjectNode node, ControlEvent event) {
    if (event instanceof ControlEvent.Start start) {
      ObjectNode switches = node.put("event", "start").putObject("switches");
      start.switches().forEach(switches::put);
      if (!start.fields().isEmpty()) {
        ObjectNode objects = node.putObject("fields");
        start.fields().forEach((object, fields) -> fields.forEach(objects.putObject(object)::put));
      }
    } else if (event instanceof ControlEvent.Enter enter) {
      node.put("event", "enter").put("sensor", enter.sensor());
      enter.schemas().forEach(node.putArray("schemas")::add);
    } else if (event instanceof ControlEvent.Exit exit) {
      node.put("event", "exit").put("sensor", exit.sensor());
      exit.schemas().forEach(node.putArray("schemas")::add);
    } else if (event instanceof ControlEvent.SwitchChange change) {
      node.put("event", "switch")
          .put("switch", change.switchName())
          .put("from", change.from())
          .put("to", change.to())
          .put("schema", change.schema());
      if (change.cause().budget()) {
        node.put("cause", "budget");
      }
      change.seen().ifPresent(seen -> put(node, seen));
    } else if (event instanceof ControlEvent.FieldChange change) {
      node.put("event", "field")
          .put("object", change.object())
          .put("quality", change.quality().spelling())
          .put("field", change.field())
          .put("from", change.from())
          .put("to", change.to())
          .put("schema", change.schema());
      change.seen().ifPresent(seen -> put(node, seen));
    }
  }

  private static void put(ObjectNode node, QualityLevels quality) {
    ObjectNode each = node.putObject(quality.quality().spelling());
    ArrayNode levels = each.put("fields", quality.fields()).putArray("levels");
    for (QualityLevels.Level level : quality.levels()) {
      levels
          .addObject()
          .put("level", level.level())
          .put("seconds", DecimalRounding.to(3, level.seconds()))
          .put("end", level.end());
    }
  }

  private static void put(ObjectNode node, SwitchVisibility seen) {
    node.put("visible", seen.visible())
        .put("pixels", Math.round(seen.pixels()))
        .put("turning", DecimalRounding.to(1, seen.turning()));
  }
}
