package org.selectiverenderer.release;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;

/**
 * The table of docs/install.md, which the notes of a release carry too, is written from
 * packaging/systems.tsv: what was tried on which system, and which machine the rest needs.
 */
class SystemsTableTest {
  private static final Path PAGE = Path.of("docs/install.md");
  private static final Path TABLE = Path.of("packaging/systems.tsv");
  private static final String BEGIN =
      "<!-- The table is written from packaging/systems.tsv by SystemsTableTest. -->\n";
  private static final String END = "<!-- End of the table -->\n";
  private static final String NOTHING = "-";

  private static final List<String> COLUMNS =
      List.of("system", "package", "in one step", "tried", "not tried", "machine");

  private static List<List<String>> rows() throws IOException {
    return Files.readAllLines(TABLE).stream().map(line -> List.of(line.split("\t"))).toList();
  }

  @Test
  void whatWasNotTriedNamesTheMachineThatItNeeds() throws IOException {
    assertThat(rows().get(0)).isEqualTo(COLUMNS);
    for (List<String> row : rows().subList(1, rows().size())) {
      assertThat(row).as("%s", row).hasSameSizeAs(COLUMNS).allMatch(cell -> !cell.isBlank());
      assertThat(row.get(4).equals(NOTHING)).as("%s", row).isEqualTo(row.get(5).equals(NOTHING));
      // The notes of a release are read where a link into another page would lead nowhere.
      assertThat(row).noneMatch(cell -> cell.contains(".md)") || cell.contains("|"));
    }
  }

  /** {@code mvn test -Dtest=SystemsTableTest -Dreports.update=true} writes the table anew. */
  @Test
  void thePageHasTheTable() throws IOException {
    String table =
        rows().stream().skip(1).map(SystemsTableTest::line).collect(Collectors.joining());
    String expected =
        "\n| system | package | in one step | tried | not tried, and the machine that it needs |\n"
            + "| --- | --- | --- | --- | --- |\n"
            + table
            + "\n";
    String page = Files.readString(PAGE).replace("\r\n", "\n");
    assertThat(page).contains(BEGIN, END);
    int begin = page.indexOf(BEGIN) + BEGIN.length();
    int end = page.indexOf(END);
    if (Boolean.getBoolean("reports.update")) {
      page = page.substring(0, begin) + expected + page.substring(end);
      Files.writeString(PAGE, page);
      end = page.indexOf(END);
    }
    assertThat(page.substring(begin, end))
        .as("%s; mvn test -Dtest=SystemsTableTest -Dreports.update=true writes it anew", PAGE)
        .isEqualTo(expected);
  }

  private static String line(List<String> row) {
    String tried = row.get(3).equals(NOTHING) ? "nothing" : row.get(3);
    String missing = row.get(4).equals(NOTHING) ? "" : row.get(4) + ": it takes " + row.get(5);
    return "| %s | %s | %s | %s | %s |\n"
        .formatted(row.get(0), row.get(1), row.get(2), tried, missing);
  }
}
