package org.selectiverenderer.apartment.lounge;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestInstance;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import org.selectiverenderer.apartment.facts.PolygonCounts;
import org.selectiverenderer.geometry.BoundingBox;
import org.selectiverenderer.geometry.mesh.MeshMeasures;
import org.selectiverenderer.modelling.ExactCountRefiner;
import org.selectiverenderer.modelling.ParametricModel;
import org.selectiverenderer.modelling.Part;

@TestInstance(TestInstance.Lifecycle.PER_CLASS)
class LoungeRecipesTest {
  /** Furnishings and what nobody expects in a lounge. */
  private static final Set<String> SINGLE =
      Set.of("carpet", "floorLamp", "painting", "barrel", "basketball", "hammer", "pumpkin");

  /** Pieces of a surface of several looks, knobs without undersides, leaves, letters. */
  private static final Map<String, Set<String>> OPEN =
      Map.ofEntries(
          Map.entry("ashTray", Set.of("dish", "ash")),
          Map.entry("barrel", Set.of("hoops")),
          Map.entry("basketball", Set.of("leather", "seams")),
          Map.entry("carpet", Set.of("fringes")),
          Map.entry("floorLamp", Set.of("shade")),
          Map.entry("glass", Set.of("wine", "glass")),
          Map.entry(
              "magazine",
              Set.of(
                  "paper",
                  "wall",
                  "floor",
                  "sofa",
                  "lamp",
                  "edges",
                  "leaf",
                  "title",
                  "text",
                  "photograph")),
          Map.entry("mobile", Set.of("keys", "call", "hangUp", "digits")),
          Map.entry(
              "remoteControl",
              Set.of("digits", "rockers", "power", "red", "green", "yellow", "blue")),
          Map.entry("speakers", Set.of("rims", "cones", "tweeters")),
          Map.entry("tv", Set.of("screen", "trim")),
          Map.entry("vase", Set.of("body", "band", "leaves")),
          Map.entry("wine", Set.of("glass", "capsule", "label", "gold", "emblem")));

  static Stream<String> names() {
    return LoungeRecipes.all().keySet().stream();
  }

  private final Map<String, ParametricModel> made = new HashMap<>();

  /** Made once for all that is asked of it. */
  private ParametricModel model(String name) {
    return made.computeIfAbsent(name, LoungeRecipesTest::make);
  }

  private static ParametricModel make(String name) {
    return LoungeRecipes.all().get(name).get();
  }

  @Test
  void theTablesObjectsAndTheRoomsOwnAreThere() {
    Set<String> all = new TreeSet<>(SINGLE);
    all.addAll(
        List.of(
            "ashTray",
            "candle",
            "cigaretteSet",
            "glass",
            "keys",
            "loungeBooks",
            "magazine",
            "mobile",
            "remoteControl",
            "sofa1Pillow",
            "sofa2Pillow",
            "speakers",
            "tv",
            "vase",
            "wine",
            "biblioteca",
            "loungeTable",
            "sofa1",
            "sofa2"));

    assertThat(LoungeRecipes.all().keySet()).isEqualTo(all);
  }

  @Test
  void whatHasOneVersionLeavesRoomForTheLoungeItself() {
    int polygons = SINGLE.stream().mapToInt(name -> model(name).polygons()).sum();

    assertThat(polygons).isLessThanOrEqualTo(3300);
  }

  @ParameterizedTest
  @MethodSource("names")
  void comesToTheTablesPolygonsWithFourFifthsOfThemItsForm(String name) {
    PolygonCounts.load()
        .of(name)
        .ifPresentOrElse(
            count -> {
              ParametricModel model = model(name);
              assertThat(model.polygons())
                  .isBetween((int) (0.8 * count.original()), count.original());
              assertThat(ExactCountRefiner.refine(model, count.original()).polygons())
                  .isEqualTo(count.original());
            },
            () -> assertThat(SINGLE).contains(name));
  }

  @ParameterizedTest
  @MethodSource("names")
  void standsOnTheGroundCentred(String name) {
    ParametricModel model = model(name);
    BoundingBox b = model.bounds();

    assertThat(model.name()).isEqualTo(name);
    assertThat(b.minY()).isCloseTo(0, within(1e-6));
    assertThat(b.minX() + b.maxX()).isCloseTo(0, within(0.02 * b.width()));
    assertThat(b.minZ() + b.maxZ()).isCloseTo(0, within(0.02 * b.depth()));
  }

  @ParameterizedTest
  @MethodSource("names")
  void hasNumbersOnlyAndTrianglesWithAnArea(String name) {
    for (Part part : model(name).parts()) {
      for (float value : part.mesh().positions()) {
        assertThat(Float.isFinite(value)).isTrue();
      }
      for (int t = 0; t < part.mesh().triangleCount(); t++) {
        assertThat(MeshMeasures.normal(part.mesh(), t).length())
            .as("triangle %d of %s", t, part.name())
            .isGreaterThan(1e-12);
      }
    }
  }

  @ParameterizedTest
  @MethodSource("names")
  void isClosedButForTheNamedParts(String name) {
    List<Part> parts = model(name).parts();

    assertThat(parts.stream().filter(p -> !p.mesh().isClosed()).map(Part::name))
        .containsExactlyInAnyOrderElementsOf(OPEN.getOrDefault(name, Set.of()));
    assertThat(parts)
        .filteredOn(p -> p.mesh().isClosed())
        .allSatisfy(p -> assertThat(MeshMeasures.volume(p.mesh())).as(p.name()).isPositive());
  }

  @ParameterizedTest
  @MethodSource("names")
  void isTheSameEveryTime(String name) {
    assertThat(model(name)).isEqualTo(make(name));
  }

  /** Width, height and depth to a third, centimetres. */
  @ParameterizedTest
  @CsvSource({
    "ashTray, 14, 4, 14",
    "candle, 17, 21, 13",
    "cigaretteSet, 11, 8, 11",
    "glass, 8, 20, 8",
    "keys, 12, 0.7, 8",
    "loungeBooks, 28, 15, 22",
    "magazine, 42, 5, 28",
    "mobile, 5, 2, 12",
    "remoteControl, 5, 2.3, 20",
    "sofa1Pillow, 45, 43, 20",
    "sofa2Pillow, 45, 43, 20",
    "speakers, 160, 34, 24",
    "tv, 102, 70, 25",
    "vase, 24, 46, 17",
    "wine, 7.5, 30, 7.5",
    "biblioteca, 263, 190, 43",
    "loungeTable, 120, 43, 70",
    "sofa1, 210, 89, 90",
    "sofa2, 175, 89, 90",
    "carpet, 270, 0.9, 180",
    "floorLamp, 48, 160, 48",
    "painting, 100, 70, 3",
    "barrel, 50, 60, 50",
    "basketball, 24, 24, 24",
    "hammer, 33, 3, 13",
    "pumpkin, 28, 24, 29"
  })
  void isAsLargeAsTheRealThing(String name, double width, double height, double depth) {
    BoundingBox b = model(name).bounds();

    assertThat(100 * b.width()).isCloseTo(width, within(width / 3));
    assertThat(100 * b.height()).isCloseTo(height, within(height / 3));
    assertThat(100 * b.depth()).isCloseTo(depth, within(depth / 3));
  }
}
