package org.selectiverenderer.authoring.ratings;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.nio.charset.Charset;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.selectiverenderer.authoring.enrichment.ChoiceMetadata;
import org.selectiverenderer.authoring.enrichment.EnrichmentScenes;
import org.selectiverenderer.authoring.ratings.ObjectNameMatcher.How;
import org.selectiverenderer.authoring.ratings.ObjectNameMatcher.Match;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.schema.ConsistencyDegree;
import org.selectiverenderer.schema.ConsistencyType;

class RatingPlanTest {
  private static final ChoiceMetadata LOW =
      ChoiceMetadata.NONE.with(ConsistencyType.INCONSISTENT).with(ConsistencyDegree.LOW);
  private static final ChoiceMetadata HIGH =
      ChoiceMetadata.NONE.with(ConsistencyType.CONSISTENT).with(ConsistencyDegree.HIGH);

  private final ProblemCollector problems = new ProblemCollector();

  private Optional<Ratings> ratings(String rows) {
    String table = "object,schema,rating\n" + rows;
    return Ratings.read("r.csv", table.getBytes(StandardCharsets.UTF_8), problems);
  }

  private static String object(String name, int versions) {
    return "<Switch DEF='Switch_" + name + "'>" + "<Shape/>".repeat(versions) + "</Switch>\n";
  }

  private RatingPlan plan(EnrichmentScenes scene, String rows) {
    Ratings ratings = ratings(rows).orElseThrow();
    ObjectNameMatcher matching =
        new ObjectNameMatcher(ratings.means().keySet(), scene.enrichment.switches());
    return RatingPlan.of(scene.enrichment, ratings, matching, true, RatingScale.BANDS);
  }

  @Test
  void manyRatingsOfAPairAreOneMean() {
    Ratings.Mean mean =
        ratings("cup,Desk,2\ncup,Desk,4.5\ncup,Desk,\n")
            .orElseThrow()
            .means()
            .get("cup")
            .get("Desk");
    assertThat(mean.value()).isCloseTo(3.25, within(1e-12));
    assertThat(mean.count()).isEqualTo(2);
  }

  @Test
  void aRatingOutOfRangeIsTold() {
    assertThat(ratings("cup,Desk,0\ncup,Desk,7\ncup,Desk,x\ncup,,3\n")).isEmpty();
    assertThat(problems.list())
        .extracting(Problem::toString)
        .containsExactly(
            "r.csv:2:10: '0' is not a rating from 1 to 6; the table is not used",
            "r.csv:3:10: '7' is not a rating from 1 to 6; the table is not used",
            "r.csv:4:10: 'x' is not a number; the table is not used",
            "r.csv:5:1: a rating needs an object and a schema; the table is not used");
  }

  @Test
  void anObjectThatTheDeskTurnsIsShownByItsFirstVersionThere() {
    EnrichmentScenes scene =
        EnrichmentScenes.with(object("TrashCan", 2) + "<ProximitySensor DEF='DeskProx'/>\n");
    RatingPlan plan = plan(scene, "trash can,OfficeSchema,5.04\ntrash can,DeskSchema,1.39\n");
    scene.perform(plan.edit("Import ratings"));
    assertThat(scene.switchNode("Switch_TrashCan").values())
        .containsExactly(LOW.with(List.of("DeskSchema")), HIGH.with(List.of("OfficeSchema")));
    assertThat(scene.sensor("DeskProx").schemas().enter()).containsExactly("DeskSchema");
    assertThat(scene.sensor("DeskProx").schemas().exit()).containsExactly("OfficeSchema");
    assertThat(scene.document.history().names()).containsExactly("Import ratings");
  }

  @Test
  void whereTheDeskTurnsNothingItIsNotNamed() {
    EnrichmentScenes scene =
        EnrichmentScenes.with(object("Mug", 2) + "<ProximitySensor DEF='DeskProx'/>\n");
    scene.perform(plan(scene, "mug,OfficeSchema,3.5\nmug,DeskSchema,4\n").edit("Import"));
    assertThat(scene.switchNode("Switch_Mug").values())
        .containsExactly(ChoiceMetadata.NONE, HIGH.with(List.of("OfficeSchema")));
  }

  @Test
  void ofManyVersionsNeutralObjectsShowOneBetween() {
    EnrichmentScenes scene = EnrichmentScenes.with(object("A", 4) + object("B", 4));
    scene.perform(plan(scene, "a,Room,3.1\nb,Room,3.9\n").edit("Import"));
    assertThat(scene.switchNode("Switch_A").values().get(1).schemas()).containsExactly("Room");
    assertThat(scene.switchNode("Switch_B").values().get(2))
        .isEqualTo(HIGH.with(new ConsistencyDegree(0.6667)).with(List.of("Room")));
  }

  @Test
  void whatWasNotRatedFollowsTheRoomThatItStandsIn() {
    EnrichmentScenes scene =
        EnrichmentScenes.with(
            "<Group>"
                + object("A", 2)
                + object("B", 2)
                + "</Group><Group>"
                + object("C", 2)
                + "</Group>"
                + object("D", 2));
    RatingPlan plan = plan(scene, "a,Kitchen,5\nc,Lounge,5\n");
    scene.perform(plan.edit("Import"));
    assertThat(scene.switchNode("Switch_B").values().get(1))
        .isEqualTo(HIGH.with(List.of("Kitchen")));
    assertThat(plan.unrated()).extracting(node -> node.name()).containsExactly("Switch_D");
  }

  @Test
  void similarNamesAreProposedButNotTaken() {
    EnrichmentScenes scene = EnrichmentScenes.with(object("CoffeeMug", 2));
    ObjectNameMatcher matching =
        new ObjectNameMatcher(
            ratings("mug,Desk,1\nsword,Desk,1\n").orElseThrow().means().keySet(),
            scene.enrichment.switches());
    assertThat(matching.matches())
        .containsExactly(
            new Match("mug", Optional.of("Switch_CoffeeMug"), How.PROPOSED),
            new Match("sword", Optional.empty(), How.NONE));
    assertThat(plan(scene, "mug,Desk,1\n").rows()).isEmpty();
    matching.choose("mug", "Switch_CoffeeMug");
    Ratings ratings = ratings("mug,Desk,1\n").orElseThrow();
    assertThat(RatingPlan.of(scene.enrichment, ratings, matching, false, RatingScale.BANDS).rows())
        .hasSize(1);
  }

  @ParameterizedTest
  @ValueSource(strings = {"UTF-8", "ISO-8859-1", "windows-1252", "UTF-16"})
  void aTableMayComeInTheEncodingsThatSpreadsheetsWrite(String encoding) {
    byte[] table =
        "object,schema,rating,\nM\u00f6bel,K\u00fcche,\"4,5\",\nM\u00f6bel,Bad\n"
            .getBytes(Charset.forName(encoding));
    assertThat(Ratings.read("r.csv", table, problems).orElseThrow().means())
        .containsExactly(Map.entry("M\u00f6bel", Map.of("K\u00fcche", new Ratings.Mean(4.5, 1))));
    assertThat(problems.list()).isEmpty();
  }

  /** Known answers: the degree (r - 1) / 5 among 0, 1/2, 1 and among 0, 1/4, 1/2, 3/4, 1. */
  @ParameterizedTest
  @CsvSource({
    "3, 1, 0", "3, 2.2, 0", "3, 2.25, 0", "3, 2.3, 1", "3, 4.7, 1", "3, 4.8, 2", "3, 6, 2",
    "5, 1.6, 0", "5, 1.7, 1", "5, 2.8, 1", "5, 2.9, 2", "5, 4.1, 2", "5, 4.2, 3", "5, 5.3, 3",
    "5, 5.4, 4", "2, 3.5, 0", "2, 3.6, 1"
  })
  void onAScaleRatingsChooseEvenlyAmongAllVersions(int versions, double rating, int version) {
    EnrichmentScenes scene = EnrichmentScenes.with(object("Cup", versions));
    Ratings ratings = ratings("Cup,Desk," + rating + "\n").orElseThrow();
    RatingPlan plan =
        RatingPlan.of(
            scene.enrichment,
            ratings,
            new ObjectNameMatcher(ratings.means().keySet(), scene.enrichment.switches()),
            true,
            RatingScale.LINEAR);

    List<ChoiceMetadata> choices = plan.rows().get(0).choices();
    assertThat(choices.get(version).schemas()).containsExactly("Desk");
    assertThat(choices.stream().filter(choice -> !choice.schemas().isEmpty())).hasSize(1);
    double degree = version / (versions - 1.0);
    assertThat(choices.get(version).degree()).contains(new ConsistencyDegree(degree));
    assertThat(choices.get(version).type())
        .contains(degree >= 0.5 ? ConsistencyType.CONSISTENT : ConsistencyType.INCONSISTENT);
  }

  /** A scale has as many levels as the object has versions: all of them keep their degrees. */
  @ParameterizedTest
  @CsvSource({"2, 1", "3, 3.5", "4, 1", "4, 3", "4, 6", "5, 4.2"})
  void onAScaleAllVersionsHaveTheirDegrees(int versions, double rating) {
    EnrichmentScenes scene = EnrichmentScenes.with(object("Cup", versions) + object("Jug", 3));
    Ratings ratings = ratings("Cup,Desk," + rating + "\n").orElseThrow();
    scene.perform(
        RatingPlan.of(
                scene.enrichment,
                ratings,
                new ObjectNameMatcher(ratings.means().keySet(), scene.enrichment.switches()),
                true,
                RatingScale.LINEAR)
            .edit("Import"));

    List<ChoiceMetadata> choices = scene.switchNode("Switch_Cup").values();
    assertThat(choices).hasSize(versions);
    for (int i = 0; i < versions; i++) {
      assertThat(choices.get(i).degree().orElseThrow().value())
          .isEqualTo((double) i / (versions - 1), within(1e-4));
      assertThat(choices.get(i).type().isPresent()).isEqualTo(!choices.get(i).schemas().isEmpty());
    }
    assertThat(scene.document.text()).doesNotContainPattern("\\d\\.\\d{5}");
    assertThat(scene.switchNode("Switch_Jug").values())
        .extracting(choice -> choice.degree().map(ConsistencyDegree::spelling).orElse(""))
        .as("follows the room, on the same scale")
        .containsExactly("low", "0.5", "high");
  }

  /** A version between the first and the last needs theirs beside it, by the bands too. */
  @Test
  void byBandsAVersionBetweenHasTheOthersDegreesBesideIt() {
    EnrichmentScenes scene = EnrichmentScenes.with(object("A", 4));
    scene.perform(plan(scene, "a,Room,3.1\n").edit("Import"));
    assertThat(scene.switchNode("Switch_A").values())
        .extracting(choice -> choice.degree().map(ConsistencyDegree::spelling).orElse(""))
        .containsExactly("low", "0.3333", "0.6667", "high");
  }

  /** By the bands, 4.2 is an expected object, however many versions there are. */
  @Test
  void byBandsAnExpectedObjectHasTheLastVersionOfFive() {
    RatingPlan plan = plan(EnrichmentScenes.with(object("Cup", 5)), "Cup,Desk,4.2\n");
    assertThat(plan.rows().get(0).choices().get(4).schemas()).containsExactly("Desk");
  }
}
