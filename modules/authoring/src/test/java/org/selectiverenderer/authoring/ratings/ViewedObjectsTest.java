package org.selectiverenderer.authoring.ratings;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.authoring.enrichment.ChoiceMetadata;
import org.selectiverenderer.authoring.enrichment.EnrichmentScenes;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.schema.ConsistencyDegree;
import org.selectiverenderer.schema.ConsistencyType;

/** What head logs name is found in a scene, and accepted proposals become its metadata. */
class ViewedObjectsTest {
  private static final String SENSORS =
      "<ProximitySensor DEF='DeskProx'/><ProximitySensor DEF='SofaProx'/>";

  private static String object(String name, int versions) {
    return "<Switch DEF='Switch_" + name + "'>" + "<Shape/>".repeat(versions) + "</Switch>\n";
  }

  private static Ratings ratings(String rows) {
    byte[] table = ("object,schema,rating\n" + rows).getBytes(StandardCharsets.UTF_8);
    return Ratings.read("r.csv", table, new ProblemCollector()).orElseThrow();
  }

  private static ViewedObjects objects(EnrichmentScenes scene, Ratings ratings) {
    return new ViewedObjects(
        scene.enrichment,
        ratings,
        new ObjectNameMatcher(ratings.means().keySet(), scene.enrichment.switches()));
  }

  private static GazeProposal proposal(String object, String schema, double degree, int versions) {
    return new GazeProposal(
        object,
        schema,
        OptionalDouble.empty(),
        degree,
        degree,
        degree,
        Optional.of(degree > 0.5 ? ConsistencyType.CONSISTENT : ConsistencyType.INCONSISTENT),
        new GazeProposal.Evidence(12, 60, 9, 20),
        versions);
  }

  @Test
  void areasAreNamedBySchemasOfTheSceneAndTheTableElseAfterThePlace() {
    EnrichmentScenes scene = EnrichmentScenes.with(object("Cup", 2) + SENSORS);
    ViewedObjects objects = objects(scene, ratings("cup,DeskSchema,2\ncup,\"Living Room\",4\n"));
    assertThat(objects.schema("Anything", true)).isEqualTo("Anything");
    assertThat(objects.schema("DeskProx", false)).isEqualTo("DeskSchema");
    assertThat(objects.schema("livingRoom", false)).isEqualTo("Living Room");
    assertThat(objects.schema("SofaProx", false)).isEqualTo("SofaSchema");
    assertThat(objects.schema("kitchen", false)).isEqualTo("KitchenSchema");
    assertThat(objects.schema("scene", false)).isEqualTo("SceneSchema");
  }

  @Test
  void ratingsAreThoseOfTheObjectThatIsTheSwitch() {
    EnrichmentScenes scene = EnrichmentScenes.with(object("Cup", 2) + SENSORS);
    ViewedObjects objects = objects(scene, ratings("cup,DeskSchema,2\ncup,DeskSchema,3\n"));
    assertThat(objects.rating("Switch_Cup", "DeskSchema")).hasValue(2.5);
    assertThat(objects.rating("Switch_Cup", "SofaSchema")).isEmpty();
    assertThat(objects.rating("Switch_Bed", "DeskSchema")).isEmpty();
    assertThat(objects.versions("Switch_Cup")).isEqualTo(2);
    assertThat(objects.versions("Switch_Bed")).isZero();
  }

  @Test
  void anAcceptedProposalTakesThePlaceOfItsRatingAndLeavesOthers() {
    EnrichmentScenes scene = EnrichmentScenes.with(object("Cup", 2) + object("Pen", 2) + SENSORS);
    Ratings table = ratings("cup,DeskSchema,6\ncup,OfficeSchema,5\npen,OfficeSchema,5\n");
    Map<String, Map<String, Ratings.Mean>> means =
        objects(scene, table)
            .with(table, List.of(proposal("Switch_Cup", "DeskSchema", 0.1, 2)), RatingScale.BANDS)
            .means();
    assertThat(means.get("cup").get("DeskSchema").value()).isCloseTo(1.4, within(1e-12));
    assertThat(means.get("cup").get("DeskSchema").count()).isEqualTo(12);
    assertThat(means.get("cup").get("OfficeSchema").value()).isEqualTo(5);
    assertThat(means.get("pen")).isEqualTo(table.means().get("pen"));
  }

  @Test
  void whatCannotBeWrittenIsLeftOut() {
    EnrichmentScenes scene = EnrichmentScenes.with(object("Cup", 1));
    assertThat(
            ViewedObjects.of(scene.enrichment)
                .with(
                    new Ratings(Map.of()),
                    List.of(
                        proposal("Switch_Cup", "DeskSchema", 0.1, 1),
                        proposal("Switch_Cup", "Desk\nSchema", 0.1, 2)),
                    RatingScale.BANDS)
                .means())
        .isEmpty();
  }

  @Test
  void theDegreeChoosesAmongTheVersions() {
    assertThat(shown(0.1)).isZero();
    assertThat(shown(0.49)).isZero();
    assertThat(shown(0.55)).isEqualTo(1);
    assertThat(shown(0.7)).isEqualTo(2);
    assertThat(shown(0.8)).isEqualTo(3);
  }

  private static int shown(double degree) {
    EnrichmentScenes scene = EnrichmentScenes.with(object("Cup", 4));
    Ratings accepted =
        ViewedObjects.of(scene.enrichment)
            .with(
                new Ratings(Map.of()),
                List.of(proposal("Switch_Cup", "DeskSchema", degree, 4)),
                RatingScale.BANDS);
    ObjectNameMatcher switches =
        new ObjectNameMatcher(accepted.means().keySet(), scene.enrichment.switches());
    List<ChoiceMetadata> choices =
        RatingPlan.of(scene.enrichment, accepted, switches, false, RatingScale.BANDS)
            .rows()
            .get(0)
            .choices();
    for (int i = 0; i < choices.size(); i++) {
      int index = i;
      if (!choices.get(i).schemas().isEmpty()) {
        assertThat(choices.get(i).type())
            .contains(i == 0 ? ConsistencyType.INCONSISTENT : ConsistencyType.CONSISTENT);
        assertThat(choices.get(i).degree().map(ConsistencyDegree::value))
            .hasValueSatisfying(own -> assertThat(own).isEqualTo(index / 3.0, within(1e-4)));
        return i;
      }
    }
    throw new AssertionError("no metadata");
  }

  @Test
  void theTableSaysWhatIsProposedAndWhy() {
    GazeProposal undecided =
        new GazeProposal(
            "Lamp",
            "DeskSchema",
            OptionalDouble.of(4.25),
            0.6,
            0.4,
            0.8,
            Optional.empty(),
            new GazeProposal.Evidence(3, 10.04, 2, 5),
            2);
    assertThat(
            GazeProposalTable.text(
                List.of(proposal("Switch_Cup", "DeskSchema", 0.125, 0), undecided)))
        .isEqualTo(
            """
            object      schema      rating  degree  90% from-to  people  in view s   dwell s  looks  proposed
            Switch_Cup  DeskSchema       -    0.13  0.13-0.13        12       60.0       9.0     20  inconsistent, but no Switch
            Lamp        DeskSchema    4.25    0.60  0.40-0.80         3       10.0       2.0      5  undecided
            """);
  }

  @Test
  void anAreaLeadsBackToTheRoomsOfItsObjectsThoughTheyAreNotClearThere() {
    EnrichmentScenes scene =
        EnrichmentScenes.with(object("Cup", 2) + "<ProximitySensor DEF='DeskProx'/>\n");
    ViewedObjects objects = ViewedObjects.of(scene.enrichment);
    List<GazeProposal> proposals =
        List.of(
            proposal("Switch_Cup", "DeskSchema", 0.1, 2),
            proposal("Switch_Cup", "OfficeSchema", 0.5, 0)); // not to be written
    Ratings accepted = objects.with(new Ratings(Map.of()), proposals, RatingScale.BANDS);
    ObjectNameMatcher switches =
        new ObjectNameMatcher(accepted.means().keySet(), scene.enrichment.switches());
    scene.perform(
        RatingPlan.of(
                scene.enrichment,
                accepted,
                objects.places(proposals),
                switches,
                false,
                RatingScale.BANDS)
            .edit("Gaze"));

    assertThat(scene.sensor("DeskProx").schemas().enter()).containsExactly("DeskSchema");
    assertThat(scene.sensor("DeskProx").schemas().exit()).containsExactly("OfficeSchema");
    assertThat(scene.switchNode("Switch_Cup").values().get(0).schemas())
        .containsExactly("DeskSchema");
  }
}
