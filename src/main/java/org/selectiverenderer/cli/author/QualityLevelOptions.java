package org.selectiverenderer.cli.author;

import java.util.List;
import java.util.Set;
import org.selectiverenderer.authoring.qualities.QualityVersionsEdit;
import org.selectiverenderer.command.output.CommandException;
import picocli.CommandLine.Option;

/** The options for levels of texture and shading. */
final class QualityLevelOptions {
  private static final Set<String> SHADING = Set.of("vertex", "flat");

  @Option(
      names = "--texture-percent",
      split = ",",
      paramLabel = "P",
      description =
          "smaller pictures of the object's textures, in percent of each side, one per level; "
              + "written beside the pictures: wood_25.png; --schemas says where each is shown")
  private List<Double> percents = List.of();

  @Option(
      names = "--shading",
      split = ",",
      paramLabel = "LEVEL",
      description = "levels of shading after pixel: vertex, flat")
  private List<String> shading = List.of();

  @Option(
      names = "--schemas",
      split = ",",
      paramLabel = "NAME",
      description =
          "schemas that select the levels, that of the object as it is first; without, the levels "
              + "follow the metadata of its versions")
  private List<String> schemas = List.of();

  boolean isEmpty() {
    return percents.isEmpty() && shading.isEmpty() && schemas.isEmpty();
  }

  QualityVersionsEdit.Request request(String object) {
    for (int i = 0; i < percents.size(); i++) {
      double before = i == 0 ? 100 : percents.get(i - 1);
      if (!(percents.get(i) > 0 && percents.get(i) < before)) {
        throw CommandException.usage(
            "--texture-percent: levels fall from below 100 to above 0, such as 50,25");
      }
    }
    for (String level : shading) {
      if (!SHADING.contains(level)) {
        throw CommandException.usage(
            "--shading: '" + level + "' is unknown; the levels after pixel are vertex and flat");
      }
    }
    if (percents.isEmpty() && shading.isEmpty()) {
      throw CommandException.usage("--schemas needs --texture-percent or --shading");
    }
    requireOneSchemaEach("--texture-percent", percents.size());
    requireOneSchemaEach("--shading", shading.size());
    return new QualityVersionsEdit.Request(object, percents, shading, schemas);
  }

  private void requireOneSchemaEach(String option, int levels) {
    if (levels > 0 && !schemas.isEmpty() && schemas.size() != levels + 1) {
      throw CommandException.usage(
          "--schemas: %s makes %d levels with the object as it is; name as many schemas%s"
              .formatted(
                  option,
                  levels + 1,
                  percents.size() == shading.size() || percents.isEmpty() || shading.isEmpty()
                      ? ""
                      : "; make --texture-percent and --shading in two runs, each with its own"));
    }
  }
}
