package org.selectiverenderer.cli.experiment;

import java.nio.file.Path;
import java.util.List;
import picocli.CommandLine.Option;

/** The option for tables of answers that were given on paper. */
final class PaperTablesOption {
  @Option(
      names = "--paper",
      paramLabel = "F.csv",
      split = ",",
      description =
          "tables of experiment paper that were filled in with answers given on paper; can be "
              + "repeated")
  private List<Path> tables = List.of();

  List<Path> tables() {
    return tables;
  }
}
