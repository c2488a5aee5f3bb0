package org.selectiverenderer.validation.files;

import java.util.List;
import java.util.Locale;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.validation.FileOutline;
import org.selectiverenderer.validation.FindingCollector;
import org.selectiverenderer.validation.SceneCheck;
import org.selectiverenderer.validation.SceneContext;

/** Checks the total size of a scene with all its files. */
final class FileSizeCheck implements SceneCheck {
  private static final double MEGABYTE = 1e6;

  @Override
  public void check(SceneContext scene, FindingCollector findings) {
    List<FileOutline> files = scene.files();
    long bytes = files.stream().mapToLong(FileOutline::bytes).sum();
    double most = scene.settings().megabytes();
    if (bytes > most * MEGABYTE) {
      findings.add(
          FileRules.SIZE,
          SourceLocation.of(scene.main().file().name()),
          "",
          files.size() - 1,
          String.format(Locale.ROOT, "%.1f", bytes / MEGABYTE),
          String.format(Locale.ROOT, most == Math.rint(most) ? "%.0f" : "%s", most));
    }
  }
}
