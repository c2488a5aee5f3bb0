package org.selectiverenderer.pages;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.study.questionnaire.AnswerTableKind;

/**
 * docs/study-keys.md, and the second half of docs/formats.md, are written from the schemas and
 * headers that the program itself uses: {@code mvn test -Dtest=KeyPagesTest -Dreports.update=true}.
 */
class KeyPagesTest {
  private static final String BELOW = "<!-- Below, all is written by KeyPagesTest. -->\n";

  @Test
  void theKeysOfAStudyAreThoseOfItsSchemas() throws IOException {
    hold(
        Path.of("docs/study-keys.md"),
        "\n## A study\n\n"
            + keys("study/definition/study.schema.json", "study")
            + "\n## A questionnaire\n\n"
            + keys("study/definition/questionnaire.schema.json", "questionnaire"));
  }

  @Test
  void theFormatsAreThoseThatTheProgramWrites() throws IOException {
    String tables =
        Stream.of(AnswerTableKind.values())
            .map(table -> "| `%s` | %s |\n".formatted(table.file(), columns(table)))
            .collect(Collectors.joining());
    hold(
        Path.of("docs/formats.md"),
        "\n## Columns of the tables of answers\n\n| file | columns |\n| --- | --- |\n"
            + tables
            + "\n## The report of `validate --format json`\n\n"
            + keys("validation/report/report.schema.json", "report")
            + "\n## The report of `doctor --format json`\n\n"
            + keys("doctor/report/doctor.schema.json", "doctor"));
  }

  private static String columns(AnswerTableKind table) {
    return Stream.of(table.header().strip().split(","))
        .map(column -> "`" + column + "`")
        .collect(Collectors.joining(", "));
  }

  private static String keys(String schema, String name) throws IOException {
    try (InputStream in =
        KeyPagesTest.class.getResourceAsStream("/org/selectiverenderer/" + schema)) {
      return new SchemaTables(new ObjectMapper().readTree(in), name).text();
    }
  }

  /** Holds what stands below the mark of a page to what it should be, or writes it anew. */
  private static void hold(Path file, String expected) throws IOException {
    String page = Files.readString(file).replace("\r\n", "\n");
    assertThat(page).contains(BELOW);
    String head = page.substring(0, page.indexOf(BELOW) + BELOW.length());
    if (Boolean.getBoolean("reports.update")) {
      page = head + expected;
      Files.writeString(file, page);
    }
    assertThat(page)
        .as("%s; mvn test -Dtest=KeyPagesTest -Dreports.update=true writes it anew", file)
        .isEqualTo(head + expected);
  }
}
