package org.selectiverenderer.apartment.office;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Collection;
import java.util.HashMap;
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestInstance;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import org.selectiverenderer.apartment.facts.PolygonCounts;
import org.selectiverenderer.apartment.facts.PolygonCounts.Counts;
import org.selectiverenderer.geometry.BoundingBox;
import org.selectiverenderer.geometry.mesh.MeshMeasures;
import org.selectiverenderer.modelling.ExactCountRefiner;
import org.selectiverenderer.modelling.ParametricModel;
import org.selectiverenderer.modelling.Part;

@TestInstance(TestInstance.Lifecycle.PER_CLASS)
class OfficeRecipesTest {
  private static final PolygonCounts COUNTS = PolygonCounts.load();

  /** They hang on a wall, their backs at z = 0. */
  private static final Set<String> HUNG = Set.of("clock", "poster");

  /** Letters, labels, pictures on screens: flat, or one side of a body that another part closes. */
  private static final Map<String, Set<String>> OPEN =
      Map.ofEntries(
          Map.entry("cd", Set.of("cover", "title")),
          Map.entry("clock", Set.of("numerals")),
          Map.entry(
              "computerSet",
              Set.of(
                  "desktop",
                  "taskBar",
                  "window",
                  "windowTitle",
                  "writing",
                  "mousePalm",
                  "mouseButtons")),
          Map.entry("deskLamp", Set.of("reflector")),
          Map.entry("fireExtinguisher", Set.of("label", "stripe")),
          Map.entry("folders", Set.of("labels", "writing")),
          Map.entry("laptop", Set.of("screen", "screenBar", "window", "title", "writing")),
          Map.entry("letterTray", Set.of("stamp")),
          Map.entry("libraryBooks", Set.of("pages", "labels")),
          Map.entry("libraryMouse", Set.of("palm", "buttons")),
          Map.entry("notepad", Set.of("writing")),
          Map.entry(
              "poster",
              Set.of("mount", "sky", "upperSky", "sun", "farHills", "middleHills", "nearHills")),
          Map.entry("printer", Set.of("print", "brand")),
          Map.entry("ruler", Set.of("lines", "numbers")),
          Map.entry("telephoneLibrary", Set.of("digits", "display")),
          Map.entry("trashCan", Set.of("body")));

  static Collection<String> all() {
    return OfficeRecipes.all().keySet();
  }

  static Stream<Counts> listed() {
    return COUNTS.all().values().stream().filter(c -> c.area().equals("office"));
  }

  private final Map<String, ParametricModel> made = new HashMap<>();

  /** Made once for all that is asked of it. */
  private ParametricModel model(String object) {
    return made.computeIfAbsent(object, OfficeRecipesTest::make);
  }

  private static ParametricModel make(String object) {
    return OfficeRecipes.all().get(object).get();
  }

  @ParameterizedTest
  @MethodSource("listed")
  void comesCloseToVersionOneByItsOwnFormAndIsRefinedToIt(Counts counts) {
    ParametricModel model = model(counts.object());

    assertThat(model.polygons()).isBetween((int) (0.8 * counts.original()), counts.original());
    assertThat(ExactCountRefiner.refine(model, counts.original()).polygons())
        .isEqualTo(counts.original());
  }

  @Test
  void theOthersFitIntoWhatTheRoomHasLeft() {
    Set<String> listed = listed().map(Counts::object).collect(Collectors.toSet());

    int polygons =
        all().stream().filter(o -> !listed.contains(o)).mapToInt(o -> model(o).polygons()).sum();

    assertThat(polygons).isBetween(1, 2900);
  }

  @ParameterizedTest
  @MethodSource("all")
  void hasSolidPartsThatFaceOutwardsAndFlatOnesWhereSaid(String object) {
    Set<String> open = OPEN.getOrDefault(object, Set.of());
    ParametricModel model = model(object);

    assertThat(model.parts()).extracting(Part::name).containsAll(open);
    assertThat(model.parts())
        .allSatisfy(
            part -> {
              assertThat(part.mesh().isClosed())
                  .as(part.name())
                  .isEqualTo(!open.contains(part.name()));
              if (part.mesh().isClosed()) {
                assertThat(MeshMeasures.volume(part.mesh())).as(part.name()).isPositive();
              }
            });
  }

  @ParameterizedTest
  @MethodSource("all")
  void standsOnTheFloorOrHangsAtTheWallInTheMiddle(String object) {
    BoundingBox b = model(object).bounds();

    if (HUNG.contains(object)) {
      assertThat(b.minZ()).isCloseTo(0, within(1e-6));
      assertThat(b.minY() + b.maxY()).isCloseTo(0, within(1e-6));
    } else {
      assertThat(b.minY()).isCloseTo(0, within(1e-6));
      assertThat((b.minZ() + b.maxZ()) / 2).isCloseTo(0, within(0.015));
    }
    assertThat((b.minX() + b.maxX()) / 2).isCloseTo(0, within(0.015));
  }

  @ParameterizedTest
  @MethodSource("all")
  void hasFinitePointsAndIsTheSameEveryTime(String object) {
    ParametricModel model = model(object);

    for (Part part : model.parts()) {
      for (float value : part.mesh().positions()) {
        assertThat(Float.isFinite(value)).isTrue();
      }
    }
    assertThat(make(object)).isEqualTo(model);
  }

  /** Centimetres. */
  @ParameterizedTest
  @CsvSource({
    "bookcase, 160, 200, 32",
    "cd, 31, 3, 14",
    "clock, 32, 32, 3",
    "computerSet, 89, 46, 63",
    "desk, 160, 74, 80",
    "deskLamp, 39, 43, 17",
    "fireExtinguisher, 21, 49, 16",
    "folders, 30, 31, 27",
    "laptop, 34, 23, 28",
    "letterTray, 27, 12, 34",
    "libraryBooks, 155, 183, 22",
    "libraryMouse, 13, 4, 16",
    "libraryPencilHolder, 9, 20, 9",
    "mug, 12, 9, 8",
    "notepad, 16, 2, 21",
    "deskChair, 63, 98, 59",
    "pencilHolderDesk, 9, 20, 9",
    "plant, 89, 124, 81",
    "poster, 90, 62, 2",
    "printer, 40, 33, 31",
    "ruler, 32, 0, 3",
    "selotape, 17, 8, 6",
    "stapler, 14, 5, 3",
    "telephoneLibrary, 23, 11, 22",
    "trashCan, 31, 32, 31",
    "trumpet, 14, 52, 12"
  })
  void isAsLargeAsInLife(String object, double width, double height, double depth) {
    BoundingBox b = model(object).bounds();

    assertThat(b.width()).isCloseTo(width / 100, within(0.01));
    assertThat(b.height()).isCloseTo(height / 100, within(0.01));
    assertThat(b.depth()).isCloseTo(depth / 100, within(0.01));
  }
}
