package org.selectiverenderer.schema;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.TreeMap;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.selectiverenderer.schema.SchemaActivation.Change;

/** Random walks through random areas, against the loops of Figs 48 and 49 written out. */
class SchemaActivationListingTest {
  private static final int SCHEMAS = 6;

  /** Looks at every switch after every step. */
  private static final class Listing {
    final List<SensorSchemas> areas = new ArrayList<>();
    final List<List<List<String>>> switches = new ArrayList<>();
    final List<Integer> entered = new ArrayList<>();
    final TreeMap<Integer, Integer> shown = new TreeMap<>();

    void enter(Integer area) {
      entered.remove(area);
      entered.add(area);
      switches.forEach(s -> areas.get(area).enter().forEach(schema -> activate(s, schema)));
    }

    void exit(Integer area) {
      entered.remove(area);
      for (List<List<String>> choices : switches) {
        List<String> claims =
            entered.stream()
                .flatMap(other -> areas.get(other).enter().stream())
                .filter(schema -> choices.stream().anyMatch(c -> c.contains(schema)))
                .toList();
        (claims.isEmpty() ? areas.get(area).exit() : claims)
            .forEach(schema -> activate(choices, schema));
      }
    }

    private void activate(List<List<String>> choices, String schema) {
      for (int i = 0; i < choices.size(); i++) {
        if (choices.get(i).contains(schema)) {
          shown.put(switches.indexOf(choices), i);
        }
      }
    }
  }

  private static List<String> schemas(Random random) {
    return random.ints(random.nextInt(3), 0, SCHEMAS).distinct().mapToObj(i -> "S" + i).toList();
  }

  @SuppressWarnings("unchecked")
  @ParameterizedTest
  @ValueSource(longs = {1, 2, 3, 4, 5, 6, 7, 8})
  void randomWalksGiveTheSameChoices(long seed) {
    Random random = new Random(seed);
    Listing listing = new Listing();
    SchemaActivation<Integer, Integer> activation = new SchemaActivation<>();
    for (int area = 0; area < 5; area++) {
      SensorSchemas schemas = new SensorSchemas(schemas(random), schemas(random));
      listing.areas.add(schemas);
      activation.putArea(area, schemas);
    }
    for (int key = 0; key < 12; key++) {
      List<List<String>> choices = new ArrayList<>();
      choices.add(List.of("unique" + key));
      for (int choice = 0; choice < 3; choice++) {
        choices.add(schemas(random));
      }
      listing.switches.add(choices);
      listing.shown.put(key, -1);
      activation.putSwitch(key, SchemaActivationTest.choices(choices.toArray(List[]::new)), -1);
    }
    for (int step = 0; step < 500; step++) {
      int area = random.nextInt(5);
      var before = new TreeMap<>(activation.shown());
      List<Change<Integer>> changes;
      if (activation.enteredAreas().contains(area)) {
        changes = activation.exit(area);
        listing.exit(area);
      } else {
        changes = activation.enter(area);
        listing.enter(area);
      }

      assertThat(activation.shown()).as("step %d", step).isEqualTo(listing.shown);
      for (Change<Integer> change : changes) {
        assertThat(change.from()).isEqualTo(before.put(change.switchKey(), change.to()));
        assertThat(change.to()).isNotEqualTo(change.from());
      }
      assertThat(before).isEqualTo(listing.shown);
    }
  }
}
