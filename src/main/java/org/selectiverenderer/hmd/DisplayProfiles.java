package org.selectiverenderer.hmd;

import com.fasterxml.jackson.core.JsonLocation;
import com.fasterxml.jackson.core.JsonParser;
import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Iterator;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import org.joml.Vector3d;
import org.selectiverenderer.x3d.Location;
import org.selectiverenderer.x3d.Problems;

/**
 * Finds a display profile by the name of a built-in one or in a JSON file:
 *
 * <pre>{@code
 * {"name": "our display", "width": 1280, "height": 1024,
 *  "field_of_view": {"diagonal": 60},          or {"horizontal": 48, "vertical": 39}, degrees
 *  "overlap": 100,                             percent
 *  "image_distance": 2.5,                      metres; left out for infinity
 *  "eye_offsets_mm": {"left": [0, 0, 0], "right": [0, 0, 0]},   right, up, back
 *  "screens": {"left": 0, "right": 1}}
 * }</pre>
 *
 * Width, height and field of view are required.
 */
public final class DisplayProfiles {
  private static final Set<String> KEYS =
      Set.of(
          "name",
          "width",
          "height",
          "field_of_view",
          "overlap",
          "image_distance",
          "eye_offsets_mm",
          "screens");

  private final String file;
  private final Problems problems;
  private boolean faulty;

  private DisplayProfiles(String file, Problems problems) {
    this.file = file;
    this.problems = problems;
  }

  /** A built-in one: {@code proview50}, {@code proview30} or {@code desk}. */
  public static Optional<DisplayProfile> builtIn(String name) {
    return Optional.ofNullable(
        switch (name.toLowerCase(Locale.ROOT)) {
          case "proview50" -> DisplayProfile.PROVIEW_50;
          case "proview30" -> DisplayProfile.PROVIEW_30;
          case "desk" -> DisplayProfile.DESK;
          default -> null;
        });
  }

  /**
   * Reads a file.
   *
   * @return empty when it has faults, which are then in {@code problems}
   * @throws IOException if the file cannot be read at all
   */
  public static Optional<DisplayProfile> read(Path path, Problems problems) throws IOException {
    return parse(path.toString(), Files.readString(path, StandardCharsets.UTF_8), problems);
  }

  /**
   * Reads a text.
   *
   * @param file its name, for messages
   */
  public static Optional<DisplayProfile> parse(String file, String text, Problems problems) {
    return new DisplayProfiles(file, problems).parse(text);
  }

  private Optional<DisplayProfile> parse(String text) {
    try {
      JsonNode root =
          new ObjectMapper().enable(JsonParser.Feature.STRICT_DUPLICATE_DETECTION).readTree(text);
      if (!root.isObject()) {
        fault("a display profile is a JSON object");
        return Optional.empty();
      }
      DisplayProfile profile = profile(root);
      return faulty ? Optional.empty() : Optional.of(profile);
    } catch (JsonProcessingException e) {
      JsonLocation at = e.getLocation();
      problems.error(
          at == null
              ? Location.of(file)
              : new Location(file, Math.max(1, at.getLineNr()), Math.max(1, at.getColumnNr())),
          "the display profile is no JSON: " + e.getOriginalMessage());
      return Optional.empty();
    }
  }

  private DisplayProfile profile(JsonNode root) {
    for (Iterator<String> names = root.fieldNames(); names.hasNext(); ) {
      String name = names.next();
      if (!KEYS.contains(name)) {
        problems.warning(
            Location.of(file), "a display profile has no \"" + name + "\"; it is passed over");
      }
    }
    int width = (int) number(root, "width", 1, 16384, Double.NaN);
    int height = (int) number(root, "height", 1, 16384, Double.NaN);
    JsonNode offsets = root.path("eye_offsets_mm");
    JsonNode screens = root.path("screens");
    FieldOfView field = field(root.path("field_of_view"), width, height);
    double overlap = number(root, "overlap", 1, 100, 100) / 100;
    double distance = number(root, "image_distance", 0.05, 1e6, Double.POSITIVE_INFINITY);
    Vector3d left = offset(offsets, "left");
    Vector3d right = offset(offsets, "right");
    int leftScreen = (int) number(screens, "left", 0, 15, 0);
    int rightScreen = (int) number(screens, "right", 0, 15, 1);
    return faulty
        ? DisplayProfile.DESK
        : new DisplayProfile(
            root.path("name").asText("own display"),
            width,
            height,
            field,
            overlap,
            distance,
            left,
            right,
            leftScreen,
            rightScreen);
  }

  private FieldOfView field(JsonNode field, int width, int height) {
    boolean diagonal = field.has("diagonal");
    if (!diagonal && !(field.has("horizontal") && field.has("vertical"))) {
      fault("\"field_of_view\" needs \"diagonal\", or \"horizontal\" and \"vertical\", in degrees");
      return DisplayProfile.DESK.fieldOfView();
    }
    if (diagonal) {
      double degrees = number(field, "diagonal", 1, FieldOfView.WIDEST, Double.NaN);
      return faulty
          ? DisplayProfile.DESK.fieldOfView()
          : FieldOfView.diagonal(degrees, width, height);
    }
    double horizontal = number(field, "horizontal", 1, FieldOfView.WIDEST, Double.NaN);
    double vertical = number(field, "vertical", 1, FieldOfView.WIDEST, Double.NaN);
    return faulty ? DisplayProfile.DESK.fieldOfView() : FieldOfView.angles(horizontal, vertical);
  }

  /** A number in a range; the default where it is missing, a fault where that is NaN. */
  private double number(JsonNode node, String key, double least, double most, double otherwise) {
    JsonNode value = node.path(key);
    if (value.isMissingNode() || value.isNull()) {
      if (Double.isNaN(otherwise)) {
        fault("\"" + key + "\" is missing");
      }
      return otherwise;
    }
    double number = value.asDouble(Double.NaN);
    if (!value.isNumber() || !(number >= least && number <= most)) {
      fault(
          String.format(
              Locale.ROOT,
              "\"%s\" is to be a number from %s to %s",
              key,
              (float) least,
              (float) most));
      return least;
    }
    return number;
  }

  private Vector3d offset(JsonNode offsets, String eye) {
    JsonNode three = offsets.path(eye);
    if (three.isMissingNode()) {
      return new Vector3d();
    }
    List<String> axes = List.of("right", "up", "back");
    Vector3d offset = new Vector3d();
    for (int axis = 0; axis < 3; axis++) {
      double millimetres = three.path(axis).asDouble(Double.NaN);
      if (three.size() != 3 || !(Math.abs(millimetres) <= 500)) {
        fault(
            "\"eye_offsets_mm\" of the %s eye are to be three numbers (%s) up to 500"
                .formatted(eye, String.join(", ", axes)));
        return new Vector3d();
      }
      offset.setComponent(axis, millimetres / 1000);
    }
    return offset;
  }

  private void fault(String message) {
    faulty = true;
    problems.error(Location.of(file), message + "; the display profile is not used");
  }
}
