package org.selectiverenderer.study.questionnaire;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.function.Function;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.formats.csv.CsvColumnSpec;
import org.selectiverenderer.formats.csv.CsvRow;
import org.selectiverenderer.formats.csv.CsvTable;
import org.selectiverenderer.study.definition.StudyTemplate;

/** The lists that a new study begins with are the thesis's (Appendices A and D), and are true. */
class ThesisItemsTest {
  /** Which of the scene's rooms a list is about. */
  private static final Map<String, String> ROOMS =
      Map.of(
          "kitchen",
          "Kitchen",
          "lounge",
          "Lounge",
          "sofa",
          "Lounge",
          "office",
          "Office",
          "desk",
          "Office",
          "bookcase",
          "Office");

  private static final Pattern PART =
      Pattern.compile("<Group DEF=[\"'](\\w+)[\"']|inlineNodes/([A-Za-z0-9]+?)(?:_v\\d+)?\\.x3d");

  @TempDir private Path folder;
  private List<CsvRow> recognition;
  private List<CsvRow> expectancy;

  @BeforeEach
  void writeTheTemplate() throws IOException {
    StudyTemplate.write(folder, Path.of("scenes/apartment.x3d"));
    recognition = rows("recognition.csv", "area,object,consistency,present,en,el,source");
    expectancy = rows("pilot/expectancy.csv", "area,schema,object,en,el,source");
  }

  private List<CsvRow> rows(String name, String columns) throws IOException {
    return CsvTable.read(
            folder.resolve(name),
            CsvColumnSpec.of(Arrays.asList(columns.split(","))),
            (at, message) -> {
              throw new AssertionError(at + message);
            })
        .orElseThrow()
        .rows();
  }

  @Test
  void asManyObjectsAreAbsentAsPresentOfEachListAndType() {
    Map<String, Map<String, Long>> counts =
        recognition.stream()
            .collect(
                Collectors.groupingBy(
                    row -> row.cell("area") + " " + row.cell("consistency"),
                    TreeMap::new,
                    Collectors.groupingBy(row -> row.cell("present"), Collectors.counting())));

    assertThat(counts)
        .hasEntrySatisfying("office neutral", count -> assertThat(count).containsEntry("yes", 20L))
        .hasEntrySatisfying("lounge neutral", count -> assertThat(count).containsEntry("yes", 17L))
        .hasEntrySatisfying("bookcase neutral", count -> assertThat(count).containsEntry("yes", 7L))
        .hasEntrySatisfying(
            "kitchen consistent", count -> assertThat(count).containsEntry("yes", 12L))
        .hasEntrySatisfying(
            "kitchen inconsistent", count -> assertThat(count).containsEntry("yes", 6L))
        .containsOnlyKeys(
            "bookcase neutral",
            "desk consistent",
            "desk inconsistent",
            "kitchen consistent",
            "kitchen inconsistent",
            "lounge neutral",
            "office neutral",
            "sofa consistent",
            "sofa inconsistent")
        .allSatisfy((list, count) -> assertThat(count.get("no")).isEqualTo(count.get("yes")));
  }

  @Test
  void whatIsPresentIsInItsRoomOfTheSceneAndNothingElseIs() throws IOException {
    Map<String, Set<String>> rooms = new TreeMap<>();
    Matcher part = PART.matcher(Files.readString(Path.of("scenes/apartment.x3d")));
    Set<String> room = new TreeSet<>();
    while (part.find()) {
      if (part.group(1) != null) {
        room = rooms.computeIfAbsent(part.group(1), name -> new TreeSet<>());
      } else {
        room.add(part.group(2));
      }
    }

    assertThat(rooms.get("Kitchen")).contains("toaster", "violin").doesNotContain("mug");
    for (CsvRow row : recognition) {
      Set<String> there = rooms.get(ROOMS.get(row.cell("area")));
      if (row.cell("present").equals("yes")) {
        assertThat(there).as(row.location().toString()).contains(row.cell("scene_object"));
      } else {
        assertThat(row.cell("scene_object")).as(row.location().toString()).isEmpty();
        assertThat(there).as(row.location().toString()).doesNotContain(row.cell("object"));
      }
    }
  }

  @Test
  void legibleRowsAreMarkedAndTheListsAreInTheAlphabeticalOrderOfTheThesis() {
    Map<String, Long> printed = thesis(recognition);

    assertThat(printed)
        .isEqualTo(
            Map.of(
                "kitchen",
                33L,
                "lounge",
                21L,
                "desk",
                16L,
                "sofa",
                12L,
                "office",
                20L,
                "bookcase",
                2L));
    assertThat(names(recognition, "desk"))
        .startsWith("Flash disk", "Web camera")
        .endsWith("Σόμπα αλογόνου", "Φωτιστικό", "Ψύκτης νερού");
    assertThat(recognition).extracting(row -> row.cell("source")).containsOnly("thesis", "ours");
  }

  /** The kitchen's list has no row of ours but in the places of the three lost ones. */
  @Test
  void theKitchensListIsThePrintedOneOf36Rows() {
    assertThat(names(recognition, "kitchen"))
        .containsExactly(
            "Αλατιέρα",
            "Απορροφητήρας",
            "Αποχυμωτής",
            "Βιολί",
            "Καρέκλες",
            "Κατσαρόλα",
            "Κονσέρβα",
            "Κούπα",
            "Κουτάλι",
            "Κρουασάν",
            "Μακαρόνια",
            "Μίξερ",
            "Μολυβοθήκη",
            "Μπαστούνι Baseball",
            "Μπρίκι",
            "Νεροπίστολο",
            "Οδοντόκρεμα",
            "Πιάτο",
            "Πιρούνι",
            "Πιστολάκι μαλλιών",
            "Ποτήρι",
            "Ρόδα ποδηλάτου",
            "Σούπα",
            "Σουρωτήρι",
            "Σύριγγα",
            "Τηγάνι",
            "Τρομπέτα",
            "Τσαγιέρα",
            "Υπολογιστής τσέπης",
            "Φούρνος μικροκυμάτων",
            "Φρούτα",
            "Φρυγανιέρα/Τοστιέρα",
            "Φτυάρι",
            "Χαρταετός",
            "Ψυγείο",
            "Ψωμί");
    assertThat(recognition)
        .filteredOn(row -> row.cell("area").equals("kitchen") && row.cell("source").equals("ours"))
        .extracting(row -> row.cell("object"))
        .containsExactly("bicycleWheel", "pocketCalculator", "microwave");
  }

  @Test
  void expectancyIsAskedOfAsManyObjectsAsInTheThesisAfterAnExample() {
    assertThat(
            expectancy.stream()
                .collect(Collectors.groupingBy(row -> row.cell("area"), Collectors.counting())))
        .isEqualTo(
            Map.of(
                "restaurant",
                2L,
                "kitchen",
                71L,
                "lounge",
                75L,
                "sofa",
                10L,
                "office",
                45L,
                "desk",
                15L,
                "bookcase",
                15L));
    assertThat(thesis(expectancy))
        .containsEntry("kitchen", 69L)
        .containsEntry("lounge", 69L)
        .containsEntry("office", 41L)
        .containsEntry("desk", 14L)
        .containsEntry("bookcase", 15L)
        .containsEntry("sofa", 10L);
    assertThat(expectancy.get(0).cell("schema")).isEqualTo(StimulusItem.EXAMPLE);
    assertThat(expectancy.subList(0, 2))
        .extracting(row -> row.cell("en"))
        .containsExactly("table", "bed");
  }

  @Test
  void namesAreInTheirOwnLanguages() {
    for (List<CsvRow> rows : List.of(recognition, expectancy)) {
      assertThat(rows).allSatisfy(row -> assertThat(row.cell("en")).matches("[\\x20-\\x7e]+"));
      assertThat(rows)
          .filteredOn(row -> !row.cell("el").matches("[\\x20-\\x7e]+"))
          .allSatisfy(
              row ->
                  assertThat(row.cell("el").toLowerCase(Locale.ROOT))
                      .containsPattern("[α-ωά-ώ]{3,}"));
    }
  }

  private static Map<String, Long> thesis(List<CsvRow> rows) {
    return rows.stream()
        .filter(row -> row.cell("source").equals("thesis"))
        .collect(Collectors.groupingBy(row -> row.cell("area"), Collectors.counting()));
  }

  private static List<String> names(List<CsvRow> rows, String area) {
    Function<CsvRow, String> name = row -> row.cell("el");
    return rows.stream().filter(row -> row.cell("area").equals(area)).map(name).toList();
  }
}
