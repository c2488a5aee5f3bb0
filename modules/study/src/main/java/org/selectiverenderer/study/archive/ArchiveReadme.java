package org.selectiverenderer.study.archive;

import java.util.List;
import java.util.Map;
import org.selectiverenderer.study.dataset.DataTable;
import org.selectiverenderer.study.definition.Study;

/** The README of a package, from what is in it. */
record ArchiveReadme(
    Study study,
    ArchivePackage.Origin origin,
    int participants,
    List<DataTable> tables,
    ArchivedFiles files) {

  String text() {
    StringBuilder text = new StringBuilder();
    text.append("# ").append(study.name()).append("\n\n");
    if (!origin.authors().isEmpty()) {
      text.append("By ").append(String.join(", ", origin.authors())).append(".\n\n");
    }
    text.append(
        """
        Data of a study with %d participants, run and written by %s.
        Licence: %s (LICENSE.txt).

        ## Files

        | file | what it is |
        | --- | --- |
        """
            .formatted(participants, origin.program(), origin.licence().id()));
    for (DataTable table : tables) {
      text.append(
          "| tables/%s.csv | a row is %s; %d rows |\n"
              .formatted(table.name(), table.meaning(), table.rows().size()));
    }
    text.append(
        """
        | tables/codebook.csv, tables/codebook.json | each column: type, unit, levels, meaning |
        | tables/tables.R, tables/tables.py | read all tables with the types of the codebook |
        | study/ | the study's own files, as the program reads them |
        | SHA256SUMS | checksums; `sha256sum -c SHA256SUMS` compares them |

        A missing value is an empty cell. A text that a spreadsheet would calculate has an apostrophe
        before it, which tables.R and tables.py take away.

        ## What was made anonymous

        - The participants' ids were given by chance, and rows are sorted by them. Nobody kept which
          id was which.
        - Times are moved by a constant for each participant, whose first session begins at
          1900-01-01T00:00:00Z; durations and differences are as they were.
        - Not in the package: answers that the study calls personal, notes of the experimenter, %s
          places in the schedule, names of machines and of recordings, those who refused consent.
        - Orders follow from the study's seed and the places in the schedule. Whoever compares the
          order of a participant's trials with `experiment plan` may learn the place, which tells
          when about the participant came.
        - The recordings of each frame (head logs) are not in the package; gaze, events and exposures
          have what was made of them.
        """
            .formatted(origin.freeTexts() ? "" : "free texts that participants wrote,"));
    if (!files.outside().isEmpty()) {
      text.append(
          """

          ## Files that the study uses and that are not in the package

          They were outside of the study's folder.

          | file | SHA-256 |
          | --- | --- |
          """);
      for (Map.Entry<String, String> file : files.outside().entrySet()) {
        text.append("| %s | %s |\n".formatted(file.getKey(), file.getValue()));
      }
    }
    return text.toString();
  }
}
