package org.selectiverenderer.apparatus;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.joml.Vector3d;
import org.selectiverenderer.base.files.InputFileReader;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.formats.json.JsonObjectReader;
import org.selectiverenderer.formats.json.JsonSettingsReader;
import org.selectiverenderer.formats.json.LocatedJsonValue;

/**
 * Loads display profiles: built-in ones by name, others from a JSON file:
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
 * Width, height and field of view are required. The file is read as {@link
 * org.selectiverenderer.formats.json} says.
 */
public final class DisplayProfileLoader {
  private static final JsonSettingsReader JSON =
      new JsonSettingsReader("a display profile", "the display profile is not used");

  private static final List<String> AXES = List.of("right", "up", "back");

  private DisplayProfileLoader() {}

  /** Returns a built-in profile: {@code proview50}, {@code proview30} or {@code desk}. */
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
   * @return the profile; empty when the file has errors, which are added to {@code problems}
   * @throws IOException if the file cannot be read or is not UTF-8
   */
  public static Optional<DisplayProfile> read(Path path, ProblemCollector problems)
      throws IOException {
    return parse(path.toString(), InputFileReader.text(path), problems);
  }

  /**
   * Reads a profile from JSON text.
   *
   * @param file the file's name, for messages
   */
  static Optional<DisplayProfile> parse(String file, String text, ProblemCollector problems) {
    return JSON.parse(file, text, problems, DisplayProfileLoader::profile);
  }

  private static DisplayProfile profile(JsonObjectReader display) {
    int width = (int) display.whole("width", 1, 16384, Double.NaN);
    int height = (int) display.whole("height", 1, 16384, Double.NaN);
    Optional<FieldOfView> field =
        display.object("field_of_view", "\"field_of_view\"", part -> field(part, width, height));
    if (field.isEmpty()) {
      angles(display);
    }
    List<Vector3d> offsets =
        display
            .object(
                "eye_offsets_mm",
                "\"eye_offsets_mm\"",
                eyes -> List.of(offset(eyes, "left"), offset(eyes, "right")))
            .orElse(List.of(new Vector3d(), new Vector3d()));
    List<Integer> screens =
        display
            .object(
                "screens",
                "\"screens\"",
                eyes ->
                    List.of(
                        (int) eyes.whole("left", 0, 15, 0), (int) eyes.whole("right", 0, 15, 1)))
            .orElse(List.of(0, 1));
    return new DisplayProfile(
        display.text("name", false).orElse("own display"),
        width,
        height,
        field.orElse(DisplayProfile.DESK.fieldOfView()),
        display.number("overlap", 1, 100, 100) / 100,
        display.number("image_distance", 0.05, 1e6, Double.POSITIVE_INFINITY),
        offsets.get(0),
        offsets.get(1),
        screens.get(0),
        screens.get(1));
  }

  private static FieldOfView field(JsonObjectReader field, int width, int height) {
    boolean diagonal = field.has("diagonal");
    boolean horizontal = field.has("horizontal");
    boolean vertical = field.has("vertical");
    if (diagonal ? horizontal || vertical : !(horizontal && vertical)) {
      angles(field);
      return DisplayProfile.DESK.fieldOfView();
    }
    return diagonal
        ? FieldOfView.diagonal(angle(field, "diagonal"), width, height)
        : FieldOfView.angles(angle(field, "horizontal"), angle(field, "vertical"));
  }

  private static void angles(JsonObjectReader at) {
    at.fault(
        "\"field_of_view\" needs \"diagonal\", or \"horizontal\" and \"vertical\", in degrees");
  }

  private static double angle(JsonObjectReader field, String key) {
    return field.number(key, 1, FieldOfView.WIDEST, Double.NaN);
  }

  /** Reads an eye's offset and converts it from millimetres to metres. */
  private static Vector3d offset(JsonObjectReader eyes, String eye) {
    if (!eyes.has(eye)) {
      return new Vector3d();
    }
    List<LocatedJsonValue> three = eyes.list(eye, false);
    Vector3d offset = new Vector3d();
    for (int axis = 0; axis < AXES.size(); axis++) {
      double millimetres = three.size() == AXES.size() ? three.get(axis).number() : Double.NaN;
      if (!(Math.abs(millimetres) <= 500)) {
        eyes.fault(
            eye,
            "\"eye_offsets_mm\" of the %s eye must be three numbers (%s) up to 500"
                .formatted(eye, String.join(", ", AXES)));
        return new Vector3d();
      }
      offset.setComponent(axis, millimetres / 1000);
    }
    return offset;
  }
}
