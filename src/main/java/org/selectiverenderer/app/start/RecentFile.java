package org.selectiverenderer.app.start;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.selectiverenderer.app.process.ProgramCommand;
import org.selectiverenderer.app.recent.RecentPaths;
import org.selectiverenderer.enricher.settings.EnricherSettings;
import org.selectiverenderer.enricher.settings.RecentFiles;

/**
 * A file that was opened lately.
 *
 * @param kind what opened it
 * @param file its path
 */
public record RecentFile(Kind kind, Path file) {
  /** Most files of each kind. */
  private static final int MOST = 6;

  /** Names the command that opens a file. */
  public enum Kind {
    SCENE,
    ENRICHED,
    STUDY
  }

  /**
   * Returns the files that were opened lately and are still there: scenes, those of the enricher,
   * studies.
   *
   * @param settings folder of the user's settings
   */
  public static List<RecentFile> list(Path settings) {
    List<RecentFile> files = new ArrayList<>();
    add(files, Kind.SCENE, RecentPaths.scenes(settings).list());
    add(files, Kind.ENRICHED, enriched(settings));
    add(files, Kind.STUDY, RecentPaths.studies(settings).list());
    return files;
  }

  private static List<Path> enriched(Path settings) {
    EnricherSettings enricher = new EnricherSettings(settings);
    try {
      enricher.load();
    } catch (IOException e) {
      return List.of(); // The enricher's window tells of settings that cannot be read.
    }
    return new RecentFiles(enricher).list();
  }

  private static void add(List<RecentFile> files, Kind kind, List<Path> found) {
    found.stream()
        .filter(Files::isRegularFile)
        .limit(MOST)
        .forEach(file -> files.add(new RecentFile(kind, file)));
  }

  /** Returns the command that opens it again. */
  public ProgramCommand command() {
    return switch (kind) {
      case SCENE -> StartCommands.show(file);
      case ENRICHED -> StartCommands.enrich(Optional.of(file));
      case STUDY -> StartCommands.studies(Optional.of(file));
    };
  }
}
