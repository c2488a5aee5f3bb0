package org.selectiverenderer.apartment.furniture;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Collection;
import java.util.HashSet;
import java.util.Map;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import org.selectiverenderer.apartment.facts.PolygonCounts;
import org.selectiverenderer.geometry.BoundingBox;
import org.selectiverenderer.geometry.mesh.MeshMeasures;
import org.selectiverenderer.modelling.ParametricModel;
import org.selectiverenderer.modelling.Part;

class FurnitureRecipesTest {
  /** They hang on a wall, their backs at z = 0. */
  private static final Set<String> HUNG =
      Set.of(
          "wideCurtains",
          "narrowCurtains",
          "whiteboard",
          "pinboard",
          "kitchenBlind",
          "rollerBlind");

  /** Panes, cloth, paper, ink: flat, seen from both sides. */
  private static final Map<String, Set<String>> OPEN =
      Map.of(
          "displayCabinet", Set.of("panes"),
          "filingCabinet", Set.of("labels"),
          "narrowCurtains", Set.of("cloth"),
          "pendantLamp", Set.of("shade"),
          "pinboard", Set.of("sheets", "yellowNotes", "pinkNotes", "blueNotes"),
          "whiteboard", Set.of("blueInk", "redInk"),
          "wideCurtains", Set.of("cloth"));

  static Collection<String> all() {
    return FurnitureRecipes.all().keySet();
  }

  private static ParametricModel model(String piece) {
    return FurnitureRecipes.all().get(piece).get();
  }

  @Test
  void noneIsAnObjectOfTheThesis() {
    Set<String> names = new HashSet<>(all());
    names.retainAll(PolygonCounts.load().all().keySet());

    assertThat(names).isEmpty();
  }

  @ParameterizedTest
  @MethodSource("all")
  void hasSolidPartsThatFaceOutwardsAndFlatOnesWhereSaid(String piece) {
    Set<String> open = OPEN.getOrDefault(piece, Set.of());
    ParametricModel model = model(piece);

    assertThat(model.parts()).extracting(Part::name).containsAll(open);
    for (Part part : model.parts()) {
      boolean closed = part.mesh().isClosed();
      assertThat(closed).as(part.name()).isEqualTo(!open.contains(part.name()));
      assertThat(part.bothSides()).as(part.name()).isEqualTo(!closed);
      if (closed) {
        assertThat(MeshMeasures.volume(part.mesh())).as(part.name()).isPositive();
      }
    }
  }

  @ParameterizedTest
  @MethodSource("all")
  void standsOnTheFloorOrHangsAtTheWallInTheMiddle(String piece) {
    BoundingBox b = model(piece).bounds();

    if (HUNG.contains(piece)) {
      assertThat(b.minZ()).isCloseTo(0, within(1e-6));
    } else {
      assertThat(b.minY()).isCloseTo(0, within(1e-6));
      assertThat((b.minZ() + b.maxZ()) / 2).isCloseTo(0, within(0.03));
    }
    assertThat((b.minX() + b.maxX()) / 2).isCloseTo(0, within(0.015));
  }

  @ParameterizedTest
  @MethodSource("all")
  void isTheSameEveryTime(String piece) {
    assertThat(model(piece)).isEqualTo(model(piece));
  }

  /** Centimetres. */
  @ParameterizedTest
  @CsvSource({
    "bench, 120, 45, 30",
    "bowl, 32, 10, 32",
    "chest, 80, 47, 43",
    "credenza, 150, 75, 42",
    "displayCabinet, 114, 185, 43",
    "filingCabinet, 46, 132, 62",
    "kitchenBlind, 160, 79, 7",
    "kitchenRug, 190, 1, 75",
    "larder, 66, 214, 61",
    "meetingTable, 90, 73, 90",
    "narrowCurtains, 259, 235, 12",
    "officeRug, 220, 1, 150",
    "pendantLamp, 50, 60, 50",
    "pinboard, 90, 60, 2",
    "pouf, 52, 40, 52",
    "rollerBlind, 200, 79, 7",
    "sideboard, 180, 74, 43",
    "visitorChair, 48, 84, 50",
    "whiteboard, 140, 91, 7",
    "wideCurtains, 319, 235, 12"
  })
  void isAsLargeAsInLife(String piece, double width, double height, double depth) {
    BoundingBox b = model(piece).bounds();

    assertThat(b.width()).isCloseTo(width / 100, within(0.01));
    assertThat(b.height()).isCloseTo(height / 100, within(0.01));
    assertThat(b.depth()).isCloseTo(depth / 100, within(0.01));
  }
}
