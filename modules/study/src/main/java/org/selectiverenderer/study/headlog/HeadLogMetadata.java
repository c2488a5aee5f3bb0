package org.selectiverenderer.study.headlog;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.selectiverenderer.formats.json.JsonTree;
import org.selectiverenderer.formats.json.JsonWriter;
import org.selectiverenderer.study.headlog.SceneMap.Area;
import org.selectiverenderer.study.headlog.SceneMap.Box;

/**
 * The metadata of a head log, in a JSON file beside its CSV: how the scene was shown, where rooms,
 * areas and objects are, and meaning and unit of each column.
 *
 * @param started date and time of the session's beginning, ISO 8601
 * @param scene the scene's file name
 * @param condition the participant's condition
 * @param seed of the random condition
 * @param display name of the display
 * @param tracker name of the head tracker
 * @param tanX tangent of half the horizontal field of view
 * @param tanY tangent of half the vertical field of view
 * @param metresPerUnit of the scene's unit of length
 * @param coneDegrees full angle of the cone about the middle of the view
 * @param eyes whether the log has the columns of gaze data
 */
public record HeadLogMetadata(
    String started,
    String scene,
    String condition,
    long seed,
    String display,
    String tracker,
    double tanX,
    double tanY,
    double metresPerUnit,
    double coneDegrees,
    boolean eyes,
    SceneMap map) {

  /**
   * Substitute for a lost description: a field of view of 50 degrees diagonally, nothing known of
   * the scene.
   */
  static final HeadLogMetadata UNKNOWN =
      new HeadLogMetadata("", "", "", 0, "", "", 0.373, 0.28, 1, 0, false, SceneMap.EMPTY);

  /** Returns the description's file for a log's CSV file. */
  public static Path beside(Path csv) {
    String name = String.valueOf(csv.getFileName());
    int dot = name.lastIndexOf('.');
    return csv.resolveSibling((dot > 0 ? name.substring(0, dot) : name) + ".json");
  }

  /** Returns the description as JSON: several lines, the last one ended. */
  public String json() {
    ObjectNode root = JsonTree.object();
    root.put("started", started);
    root.put("scene", scene);
    root.put("condition", condition);
    root.put("seed", seed);
    root.put("display", display);
    root.put("tracker", tracker);
    root.putObject("field_of_view")
        .put("half_tangent_x", tanX)
        .put("half_tangent_y", tanY)
        .put("horizontal_degrees", degrees(tanX))
        .put("vertical_degrees", degrees(tanY));
    root.put("metres_per_unit", metresPerUnit);
    root.put("cone_degrees", coneDegrees);
    if (eyes) {
      root.put("eyes", true);
    }
    ObjectNode columns = root.putObject("columns");
    for (HeadLogColumn column : HeadLogColumn.of(eyes)) {
      ObjectNode node = columns.putObject(column.header()).put("description", column.meaning);
      if (!column.units.isEmpty()) {
        node.put("units", column.units).put("decimals", column.decimals);
      }
    }
    ObjectNode drawn = root.putObject("map");
    ArrayNode areas = drawn.putArray("areas");
    for (Area area : map.areas()) {
      ArrayNode outline = areas.addObject().put("name", area.name()).putArray("outline_xz");
      area.outline().forEach(corner -> outline.addArray().add(corner[0]).add(corner[1]));
    }
    boxes(drawn.putArray("rooms"), map.rooms());
    boxes(drawn.putArray("objects"), map.objects());
    boxes(drawn.putArray("surroundings"), map.surroundings());
    return JsonWriter.of(root);
  }

  private static double degrees(double tangent) {
    return Math.round(2e3 * Math.toDegrees(Math.atan(tangent))) / 1e3;
  }

  private static void boxes(ArrayNode array, List<Box> boxes) {
    for (Box box : boxes) {
      ArrayNode bounds = array.addObject().put("name", box.name()).putArray("box");
      for (double bound : box.bounds()) {
        bounds.add(bound);
      }
    }
  }

  /** Reads what {@link #json} wrote; a missing member gets the value of {@link #UNKNOWN}. */
  static HeadLogMetadata of(JsonNode root) {
    JsonNode field = root.path("field_of_view");
    JsonNode drawn = root.path("map");
    List<Area> areas = new ArrayList<>();
    for (JsonNode area : drawn.path("areas")) {
      List<double[]> outline = new ArrayList<>();
      for (JsonNode corner : area.path("outline_xz")) {
        outline.add(new double[] {corner.path(0).asDouble(), corner.path(1).asDouble()});
      }
      areas.add(new Area(area.path("name").asText(), outline));
    }
    return new HeadLogMetadata(
        root.path("started").asText(""),
        root.path("scene").asText(""),
        root.path("condition").asText(""),
        root.path("seed").asLong(0),
        root.path("display").asText(""),
        root.path("tracker").asText(""),
        positive(field.path("half_tangent_x"), UNKNOWN.tanX),
        positive(field.path("half_tangent_y"), UNKNOWN.tanY),
        positive(root.path("metres_per_unit"), 1),
        root.path("cone_degrees").asDouble(0),
        root.path("eyes").asBoolean(false),
        new SceneMap(
            areas,
            boxes(drawn.path("rooms")),
            boxes(drawn.path("objects")),
            boxes(drawn.path("surroundings"))));
  }

  private static double positive(JsonNode node, double otherwise) {
    double value = node.asDouble(otherwise);
    return value > 0 ? value : otherwise;
  }

  private static List<Box> boxes(JsonNode array) {
    List<Box> boxes = new ArrayList<>();
    for (JsonNode box : array) {
      double[] bounds = new double[6];
      for (int i = 0; i < 6; i++) {
        bounds[i] = box.path("box").path(i).asDouble();
      }
      boxes.add(new Box(box.path("name").asText(), bounds));
    }
    return boxes;
  }
}
