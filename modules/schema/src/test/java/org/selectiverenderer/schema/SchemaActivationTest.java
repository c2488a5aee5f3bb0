package org.selectiverenderer.schema;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Nested;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.schema.SchemaActivation.Change;

class SchemaActivationTest {
  private final SchemaActivation<String, String> activation = new SchemaActivation<>();

  private void area(String name, List<String> enter, List<String> exit) {
    activation.putArea(name, new SensorSchemas(enter, exit));
  }

  /** A switch whose child i belongs to the schemas i. */
  @SafeVarargs
  private void object(String name, int shown, List<String>... schemas) {
    activation.putSwitch(name, choices(schemas), shown);
  }

  @SafeVarargs
  static SwitchSchemas choices(List<String>... schemas) {
    return new SwitchSchemas(
        IntStream.range(0, schemas.length)
            .mapToObj(i -> new VersionMetadata(i, Optional.empty(), Optional.empty(), schemas[i]))
            .toList());
  }

  private static Change<String> change(String key, int from, int to, String schema) {
    return new Change<>(key, from, to, schema);
  }

  /** The office of Table 5: choice 0 is the high version, shown in its own sub-area. */
  private void office() {
    area("Desk", List.of("DeskSchema"), List.of("OfficeSchema"));
    area("Bookcase", List.of("BookcaseSchema"), List.of("OfficeSchema"));
    object("trashCan", 1, List.of("DeskSchema"), List.of("OfficeSchema"));
    object("printer", 1, List.of("BookcaseSchema"), List.of("OfficeSchema"));
    object("lamp", 1, List.of(), List.of("OfficeSchema"));
  }

  @Nested
  class OneArea {
    @Test
    void enteringActivatesTheEnterSchemaAndLeavingTheExitSchema() {
      office();

      assertThat(activation.enter("Desk")).containsExactly(change("trashCan", 1, 0, "DeskSchema"));
      assertThat(activation.exit("Desk")).containsExactly(change("trashCan", 0, 1, "OfficeSchema"));
    }

    @Test
    void aSwitchThatShowsTheChoiceAlreadyDoesNotChange() {
      office();
      object("trashCan2", 0, List.of("DeskSchema"), List.of("OfficeSchema"));

      assertThat(activation.enter("Desk"))
          .extracting(Change::switchKey)
          .containsExactly("trashCan");
    }

    @Test
    void severalSchemasAreActivatedAtOnceAsInFigure47() {
      area("Both", List.of("Schema1", "Schema2"), List.of());
      object("a", -1, List.of("Schema1"));
      object("b", -1, List.of("Schema2"));

      assertThat(activation.enter("Both"))
          .containsExactly(change("a", -1, 0, "Schema1"), change("b", -1, 0, "Schema2"));
    }

    @Test
    void ofSeveralSchemasOfAnAreaTheLastOneNamedWins() {
      area("Both", List.of("Schema1", "Schema2"), List.of());
      object("a", -1, List.of("Schema2"), List.of("Schema1"));

      assertThat(activation.enter("Both")).containsExactly(change("a", -1, 0, "Schema2"));
    }

    @Test
    void ofTwoSetsWithTheSameSchemaTheLastOneWinsAsInFigure49() {
      area("A", List.of("S"), List.of());
      object("a", -1, List.of("S"), List.of("S"));

      assertThat(activation.enter("A")).containsExactly(change("a", -1, 1, "S"));
    }

    @Test
    void withoutAnExitSchemaForItASwitchStaysAsItIs() {
      area("A", List.of("S"), List.of("T"));
      object("a", 1, List.of("S"), List.of());
      activation.enter("A");

      assertThat(activation.exit("A")).isEmpty();
      assertThat(activation.shown()).containsEntry("a", 0);
    }

    @Test
    void leavingAnAreaThatWasNotEnteredActivatesItsExitSchemaAsInFigure48() {
      office();
      activation.putSwitch("clock", choices(List.of(), List.of("OfficeSchema")), 0);

      assertThat(activation.exit("Desk")).containsExactly(change("clock", 0, 1, "OfficeSchema"));
    }

    @Test
    void changesComeInTheOrderInWhichSwitchesWereMadeKnown() {
      area("A", List.of("S"), List.of());
      List<String> names = IntStream.range(0, 50).mapToObj(i -> "s" + i * 7 % 50).toList();
      names.forEach(name -> object(name, -1, List.of("S")));

      assertThat(activation.enter("A")).extracting(Change::switchKey).isEqualTo(names);
    }

    @Test
    void anUnknownAreaIsRefused() {
      assertThatIllegalArgumentException().isThrownBy(() -> activation.enter("nowhere"));
      assertThatIllegalArgumentException().isThrownBy(() -> activation.exit("nowhere"));
    }
  }

  @Nested
  class OverlappingAreas {
    @Test
    void leavingTheDeskInsideTheBookcaseKeepsBookcaseObjectsHigh() {
      office();
      activation.enter("Desk");
      activation.enter("Bookcase");
      assertThat(activation.shown()).isEqualTo(Map.of("trashCan", 0, "printer", 0, "lamp", 1));

      assertThat(activation.exit("Desk")).containsExactly(change("trashCan", 0, 1, "OfficeSchema"));
      assertThat(activation.exit("Bookcase"))
          .containsExactly(change("printer", 0, 1, "OfficeSchema"));
    }

    @Test
    void leavingTheBookcaseInsideTheDeskKeepsDeskObjectsHigh() {
      office();
      activation.enter("Desk");
      activation.enter("Bookcase");

      assertThat(activation.exit("Bookcase"))
          .containsExactly(change("printer", 0, 1, "OfficeSchema"));
      assertThat(activation.shown()).containsEntry("trashCan", 0);
    }

    @Test
    void theOtherOrderOfEnteringGivesTheSame() {
      office();
      activation.enter("Bookcase");
      activation.enter("Desk");
      assertThat(activation.shown()).isEqualTo(Map.of("trashCan", 0, "printer", 0, "lamp", 1));

      activation.exit("Desk");
      assertThat(activation.shown()).isEqualTo(Map.of("trashCan", 1, "printer", 0, "lamp", 1));
      activation.exit("Bookcase");
      assertThat(activation.shown()).isEqualTo(Map.of("trashCan", 1, "printer", 1, "lamp", 1));
    }

    @Test
    void theAreaEnteredLastWinsAndWhenItIsLeftTheOthersChoiceReturns() {
      area("A", List.of("SA"), List.of("Main"));
      area("B", List.of("SB"), List.of("Main"));
      object("x", 2, List.of("SA"), List.of("SB"), List.of("Main"));

      assertThat(activation.enter("A")).containsExactly(change("x", 2, 0, "SA"));
      assertThat(activation.enter("B")).containsExactly(change("x", 0, 1, "SB"));
      assertThat(activation.exit("B")).containsExactly(change("x", 1, 0, "SA"));
      assertThat(activation.exit("A")).containsExactly(change("x", 0, 2, "Main"));
    }

    @Test
    void leavingTheAreaEnteredFirstChangesNothingThatTheLastOneClaims() {
      area("A", List.of("SA"), List.of("Main"));
      area("B", List.of("SB"), List.of("Main"));
      object("x", 2, List.of("SA"), List.of("SB"), List.of("Main"));
      activation.enter("A");
      activation.enter("B");

      assertThat(activation.exit("A")).isEmpty();
      assertThat(activation.exit("B")).containsExactly(change("x", 1, 2, "Main"));
    }

    @Test
    void leavingTheSubAreaReturnsToTheAreaAroundItEvenWithoutAnExitSchema() {
      area("Room", List.of("OfficeSchema"), List.of());
      area("Desk", List.of("DeskSchema"), List.of());
      object("trashCan", -1, List.of("DeskSchema"), List.of("OfficeSchema"));
      activation.enter("Room");
      activation.enter("Desk");

      assertThat(activation.exit("Desk")).containsExactly(change("trashCan", 0, 1, "OfficeSchema"));
    }

    @Test
    void anAreaEnteredAgainCountsAsEnteredLast() {
      area("A", List.of("SA"), List.of());
      area("B", List.of("SB"), List.of());
      object("x", -1, List.of("SA"), List.of("SB"));
      activation.enter("A");
      activation.enter("B");

      assertThat(activation.enter("A")).containsExactly(change("x", 1, 0, "SA"));
      assertThat(activation.enteredAreas()).containsExactly("B", "A");
    }
  }

  @Nested
  class ActiveSchemas {
    @Test
    void mainSchemasComeFirstThenThoseOfTheAreasInTheOrderOfEntering() {
      office();
      assertThat(activation.activeSchemas()).isEmpty();
      activation.exit("Bookcase");
      activation.enter("Bookcase");
      activation.enter("Desk");

      assertThat(activation.activeSchemas())
          .containsExactly("OfficeSchema", "BookcaseSchema", "DeskSchema");
      assertThat(activation.enteredAreas()).containsExactly("Bookcase", "Desk");
    }

    @Test
    void aSchemaEndsWithItsArea() {
      office();
      activation.enter("Desk");
      activation.exit("Desk");

      assertThat(activation.activeSchemas()).containsExactly("OfficeSchema");
    }

    @Test
    void theMainSchemaOfARoomEndsWhenTheRoomIsLeft() {
      area("Room", List.of("OfficeSchema"), List.of("HallSchema"));
      area("Desk", List.of("DeskSchema"), List.of("OfficeSchema"));
      activation.enter("Room");
      activation.enter("Desk");
      activation.exit("Desk");
      assertThat(activation.activeSchemas()).containsExactly("OfficeSchema");
      activation.exit("Room");

      assertThat(activation.activeSchemas()).containsExactly("HallSchema");
    }
  }

  @Nested
  class ChangingScenes {
    @Test
    void aSwitchThatAppearsFollowsTheEnteredAreas() {
      office();
      activation.enter("Desk");

      assertThat(activation.putSwitch("clock", choices(List.of("DeskSchema")), -1))
          .contains(change("clock", -1, 0, "DeskSchema"));
    }

    @Test
    void aSwitchThatGetsOtherSchemasKeepsWhatItShowsAndItsPlace() {
      office();
      activation.putSwitch("trashCan", choices(List.of("BookcaseSchema"), List.of("X")), 7);

      assertThat(activation.enter("Desk")).isEmpty();
      assertThat(activation.enter("Bookcase"))
          .containsExactly(
              change("trashCan", 1, 0, "BookcaseSchema"),
              change("printer", 1, 0, "BookcaseSchema"));
    }

    @Test
    void aSwitchThatIsGoneIsNotChanged() {
      office();
      activation.removeSwitch("trashCan");

      assertThat(activation.enter("Desk")).isEmpty();
      assertThat(activation.shown()).doesNotContainKey("trashCan");
    }

    @Test
    void anEnteredAreaThatIsGoneClaimsNothingAndActivatesNoExitSchema() {
      area("A", List.of("SA"), List.of("Main"));
      area("B", List.of("SB"), List.of("Main"));
      object("x", 2, List.of("SA"), List.of("SB"), List.of("Main"));
      activation.enter("A");
      activation.enter("B");

      assertThat(activation.removeArea("B")).containsExactly(change("x", 1, 0, "SA"));
      assertThat(activation.removeArea("A")).isEmpty();
      assertThat(activation.enteredAreas()).isEmpty();
    }
  }

  @Nested
  class Cost {
    @Test
    void ofAHundredThousandSwitchesOnlyTheAffectedOnesAreLookedAt() {
      office();
      for (int i = 0; i < 100_000; i++) {
        object("other" + i, 1, List.of("Sub" + i / 10), List.of("OfficeSchema"));
      }
      area("Sub", List.of("Sub42"), List.of("OfficeSchema"));
      long before = activation.looks();

      List<Change<String>> changes = new ArrayList<>(activation.enter("Sub"));
      changes.addAll(activation.exit("Sub"));

      assertThat(changes).hasSize(20);
      assertThat(activation.looks() - before).isEqualTo(20);
    }
  }
}
