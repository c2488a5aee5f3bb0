package org.selectiverenderer.cli.experiment;

import java.io.IOException;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.command.output.CommandException;
import org.selectiverenderer.study.session.LoadedStudy;
import org.selectiverenderer.study.site.StudySites;
import picocli.CommandLine.Option;

/** The options for the folders of several sites at which a study runs. */
final class SitesOption {
  private static final Pattern SITE = Pattern.compile("([0-9A-Za-z]{1,32})=(.+)");

  @Option(
      names = "--from",
      paramLabel = "NAME=DIR",
      description =
          "takes the sessions of a site from a folder; can be repeated. Ids of participants get the"
              + " name before them (letters and digits), and tables a column site")
  private List<String> from = List.of();

  @Option(
      names = "--any-version",
      description =
          "takes sessions of other versions of the study from these folders, too; they are told")
  private boolean anyVersion;

  /** Returns whether sites are named. */
  boolean any() {
    if (anyVersion && from.isEmpty()) {
      throw CommandException.usage("--any-version needs the folders of sites: --from NAME=DIR");
    }
    return !from.isEmpty();
  }

  /**
   * Reads the folders of the sites.
   *
   * @return empty when they cannot be put together, which is then in {@code problems}
   */
  Optional<StudySites> read(LoadedStudy material, ProblemCollector problems) throws IOException {
    Map<String, Path> folders = new LinkedHashMap<>();
    for (String one : from) {
      Matcher parts = SITE.matcher(one);
      if (!parts.matches()) {
        throw CommandException.usage(
            "--from "
                + one
                + ": is no site and folder; write the site's name in letters and digits, =, and its"
                + " folder, as in --from athens=data/athens");
      }
      if (folders.put(parts.group(1), Path.of(parts.group(2))) != null) {
        throw CommandException.usage(
            "--from: there are two sites %s; name each once".formatted(parts.group(1)));
      }
    }
    return StudySites.read(material, folders, anyVersion, problems);
  }
}
