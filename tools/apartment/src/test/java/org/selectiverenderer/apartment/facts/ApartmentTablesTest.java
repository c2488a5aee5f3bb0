package org.selectiverenderer.apartment.facts;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.selectiverenderer.apartment.facts.ExpectancyRatings.Ratings;
import org.selectiverenderer.apartment.facts.PolygonCounts.Counts;
import org.selectiverenderer.schema.RatingBand;

class ApartmentTablesTest {

  @ParameterizedTest
  @CsvSource({
    "1, NON_EXPECTANT",
    "3, NON_EXPECTANT",
    "3.0001, NEUTRAL",
    "3.9999, NEUTRAL",
    "4, EXPECTANT",
    "6, EXPECTANT"
  })
  void bandsHaveTheBoundsOfTheThesis(double rating, RatingBand band) {
    assertThat(RatingBand.of(rating)).isEqualTo(band);
  }

  @Test
  void theObjectsThatRevolveAreThoseOfTheThesis() {
    assertThat(revolvingIn("SofaSchema"))
        .containsExactlyInAnyOrder("ashTray", "candle", "glass", "vase", "wine");
    assertThat(revolvingIn("DeskSchema"))
        .containsExactlyInAnyOrder("trashCan", "clock", "fireExtinguisher", "plant");
    assertThat(revolvingIn("BookcaseSchema"))
        .containsExactlyInAnyOrder(
            "printer", "mug", "laptop", "libraryMouse", "telephoneLibrary", "libraryPencilHolder");
  }

  private static List<String> revolvingIn(String schema) {
    ExpectancyRatings expectancies = ExpectancyRatings.load();
    return PolygonCounts.load().all().keySet().stream()
        .filter(
            object ->
                expectancies
                    .of(object)
                    .filter(r -> r.revolves() && r.subSchema().equals(schema))
                    .isPresent())
        .toList();
  }

  @Test
  void whatIsNotExpectedInTheRoomAtAllDoesNotRevolve() {
    assertThat(new Ratings("A", 2, "B", 1).revolves()).isFalse();
    assertThat(new Ratings("A", 5, "B", 3.5).revolves()).isFalse();
  }

  @Test
  void everyTableIsThere() {
    PolygonCounts counts = PolygonCounts.load();

    assertThat(counts.all()).hasSize(50);
    assertThat(counts.of("trashCan")).hasValue(new Counts("office", "trashCan", 1064, 93));
    assertThat(counts.of("shovel")).isEmpty();
    assertThat(counts.all().values()).allMatch(c -> c.reduced() < c.original());
  }

  @Test
  void objectsComeInTheOrderOfTheTables() {
    assertThat(PolygonCounts.load().all().values())
        .extracting(Counts::area)
        .isSorted()
        .startsWith("kitchen")
        .endsWith("office");
  }
}
