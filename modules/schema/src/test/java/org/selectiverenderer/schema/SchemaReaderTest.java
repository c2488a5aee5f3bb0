package org.selectiverenderer.schema;

import static org.assertj.core.api.Assertions.assertThat;
import static org.selectiverenderer.schema.TestMetadataNode.choice;
import static org.selectiverenderer.schema.TestMetadataNode.set;
import static org.selectiverenderer.schema.TestMetadataNode.string;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Nested;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.schema.SchemaProblem.Kind;

class SchemaReaderTest {
  private final List<SchemaProblem> problems = new ArrayList<>();
  private final SchemaReader reader = new SchemaReader(problems::add);

  private List<Kind> kinds() {
    return problems.stream().map(SchemaProblem::kind).toList();
  }

  @Nested
  class Sensors {
    @Test
    void readsEnterAndExitSchemas() {
      TestMetadataNode figure77 =
          set(string("enterTimeSchema", "DeskSchema"), string("exitTimeSchema", "OfficeSchema"));

      assertThat(reader.sensor(figure77))
          .contains(new SensorSchemas(List.of("DeskSchema"), List.of("OfficeSchema")));
      assertThat(problems).isEmpty();
    }

    @Test
    void readsTheNamesOfFigure40() {
      TestMetadataNode metadata =
          set(
              string("enterTimeSchemaActivation", "DeskSchema"),
              string("exitTimeSchemaActivation", "OfficeSchema"));

      assertThat(reader.sensor(metadata))
          .contains(new SensorSchemas(List.of("DeskSchema"), List.of("OfficeSchema")));
    }

    @Test
    void readsSeveralStringsOfOneNameAsFigure47HasThem() {
      TestMetadataNode figure47 =
          set(string("enterTimeSchema", "Schema1"), string("enterTimeSchema", "Schema2"));

      assertThat(reader.sensor(figure47).orElseThrow().enter())
          .containsExactly("Schema1", "Schema2");
    }

    @Test
    void readsSeveralValuesOfOneStringWithoutSpacesOrRepetition() {
      TestMetadataNode metadata = set(string(" enterTimeSchema ", " A", "B ", "", "A"));

      assertThat(reader.sensor(metadata).orElseThrow().enter()).containsExactly("A", "B");
      assertThat(problems).isEmpty();
    }

    @Test
    void readsASingleStringWithoutASet() {
      assertThat(reader.sensor(string("enterTimeSchema", "A")))
          .contains(new SensorSchemas(List.of("A"), List.of()));
    }

    @Test
    void readsSetsWithinSets() {
      TestMetadataNode metadata =
          set(set(string("enterTimeSchema", "A")), string("exitTimeSchema", "B"));

      assertThat(reader.sensor(metadata)).contains(new SensorSchemas(List.of("A"), List.of("B")));
    }

    @Test
    void leavesOtherMetadataAlone() {
      assertThat(reader.sensor(set(string("author", "me")))).isEmpty();
      assertThat(problems).isEmpty();
    }

    @Test
    void reportsAFieldThatNamesNoSchema() {
      TestMetadataNode empty = string("enterTimeSchema", " ");

      assertThat(reader.sensor(set(empty))).contains(new SensorSchemas(List.of(), List.of()));
      assertThat(problems)
          .containsExactly(
              new SchemaProblem(
                  Kind.NO_SCHEMA, "enterTimeSchema names no schema; it is ignored", empty));
    }

    @Test
    void reportsWordsThatBelongToAnObject() {
      assertThat(reader.sensor(set(string("schemaBelonginess", "A")))).isEmpty();
      assertThat(kinds()).containsExactly(Kind.MISPLACED);
    }
  }

  @Nested
  class Switches {
    @Test
    void describesChildrenInTheOrderOfTheSets() {
      TestMetadataNode figure78 =
          set(
              choice("consistent", "low", "DeskSchema"),
              choice("consistent", "high", "OfficeSchema"));

      SwitchSchemas schemas = reader.switchNode(figure78, 2).orElseThrow();

      assertThat(schemas.choices())
          .containsExactly(
              new VersionMetadata(
                  0,
                  Optional.of(ConsistencyType.CONSISTENT),
                  Optional.of(ConsistencyDegree.LOW),
                  List.of("DeskSchema")),
              new VersionMetadata(
                  1,
                  Optional.of(ConsistencyType.CONSISTENT),
                  Optional.of(ConsistencyDegree.HIGH),
                  List.of("OfficeSchema")));
      assertThat(problems).isEmpty();
    }

    @Test
    void keepsThePlaceOfAnEmptySet() {
      SwitchSchemas schemas =
          reader.switchNode(set(set(), choice("consistent", "high", "K")), 2).orElseThrow();

      assertThat(schemas.choices().get(0).schemas()).isEmpty();
      assertThat(schemas.choiceBySchema()).containsExactly(java.util.Map.entry("K", 1));
      assertThat(problems).isEmpty();
    }

    @Test
    void readsAChoiceWithoutASetAroundItAsTheFirst() {
      assertThat(reader.switchNode(string("schemaBelonginess", "A", "B"), 1))
          .contains(
              new SwitchSchemas(
                  List.of(
                      new VersionMetadata(
                          0, Optional.empty(), Optional.empty(), List.of("A", "B")))));
      assertThat(reader.switchNode(choice("consistent", "0.25", "A"), 1).orElseThrow().choices())
          .extracting(VersionMetadata::degree)
          .containsExactly(Optional.of(new ConsistencyDegree(0.25)));
      assertThat(problems).isEmpty();
    }

    @Test
    void leavesOtherMetadataAlone() {
      assertThat(reader.switchNode(set(set(string("copyright", "me"))), 3)).isEmpty();
      assertThat(problems).isEmpty();
    }

    @Test
    void reportsAChoiceThatNamesNoSchema() {
      reader.switchNode(set(set(string("degreeOfConsistency", "high"))), 1);

      assertThat(kinds()).containsExactly(Kind.NO_SCHEMA);
    }

    @Test
    void aDegreeAloneIsALevelOfAScaleWhereAnotherChoiceNamesASchema() {
      TestMetadataNode level = set(string("degreeOfConsistency", "high"));
      TestMetadataNode shown = choice("inconsistent", "low", "Desk");

      assertThat(reader.switchNode(set(shown, level), 2).orElseThrow().leastDetailed()).isOne();
      assertThat(problems).isEmpty();
    }

    @Test
    void doesNotExpectASchemaOfAFrameObject() {
      reader.switchNode(set(set(string("typeOfConsistency", "Frame"))), 1);

      assertThat(problems).isEmpty();
    }

    @Test
    void reportsUnknownTypeAndDegreeAndGoesOnWithoutThem() {
      SwitchSchemas schemas =
          reader.switchNode(set(choice("surprising", "medium", "A")), 1).orElseThrow();

      assertThat(kinds()).containsExactly(Kind.UNKNOWN_TYPE, Kind.UNKNOWN_DEGREE);
      assertThat(problems.get(1).message())
          .isEqualTo(
              "degreeOfConsistency must be low, high or a number from 0 to 1, not "
                  + "\"medium\"; it is ignored");
      assertThat(schemas.choices().get(0))
          .isEqualTo(new VersionMetadata(0, Optional.empty(), Optional.empty(), List.of("A")));
    }

    @Test
    void reportsSeveralDegreesOfOneChoice() {
      TestMetadataNode metadata =
          set(set(string("degreeOfConsistency", "low", "high"), string("schemaBelonginess", "A")));

      assertThat(reader.switchNode(metadata, 1).orElseThrow().choices().get(0).degree())
          .contains(ConsistencyDegree.LOW);
      assertThat(kinds()).containsExactly(Kind.SEVERAL_VALUES);
    }

    @Test
    void ignoresSetsThatHaveNoChild() {
      TestMetadataNode beyond = choice("consistent", "high", "B");

      SwitchSchemas schemas =
          reader.switchNode(set(choice("consistent", "low", "A"), beyond), 1).orElseThrow();

      assertThat(schemas.choiceBySchema()).containsOnlyKeys("A");
      assertThat(problems)
          .containsExactly(
              new SchemaProblem(
                  Kind.MORE_SETS_THAN_CHOICES,
                  "2 MetadataSets for 1 child of the Switch; this one is ignored",
                  beyond));
    }

    @Test
    void reportsChildrenThatHaveNoSet() {
      reader.switchNode(set(choice("consistent", "low", "A")), 3);

      assertThat(problems)
          .extracting(SchemaProblem::message)
          .containsExactly(
              "1 MetadataSet for 3 children of the Switch; no schema shows the other "
                  + "children");
    }

    @Test
    void givesNothingForASwitchWithoutChildren() {
      assertThat(reader.switchNode(set(choice("consistent", "low", "A")), 0)).isEmpty();
      assertThat(kinds()).containsExactly(Kind.MORE_SETS_THAN_CHOICES);
    }

    @Test
    void reportsWordsBesideTheSets() {
      reader.switchNode(set(string("schemaBelonginess", "A"), choice("consistent", "low", "B")), 1);

      assertThat(kinds()).containsExactly(Kind.MISPLACED);
    }

    @Test
    void survivesASetThatHoldsItself() {
      List<MetadataNode> children = new ArrayList<>();
      MetadataNode loop =
          new MetadataNode() {
            @Override
            public Optional<MetadataNode> metadata() {
              return Optional.empty();
            }

            @Override
            public boolean isSet() {
              return true;
            }

            @Override
            public String name() {
              return "";
            }

            @Override
            public List<String> values() {
              return List.of();
            }

            @Override
            public List<MetadataNode> children() {
              return children;
            }
          };
      children.add(loop);
      children.add(string("schemaBelonginess", "A"));

      assertThat(reader.switchNode(loop, 1).orElseThrow().choiceBySchema()).containsOnlyKeys("A");
    }
  }
}
