package org.selectiverenderer.app.replication;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import org.selectiverenderer.authoring.file.DocumentFile;
import org.selectiverenderer.authoring.packaging.PackageLayout;
import org.selectiverenderer.authoring.packaging.PackageWriter;
import org.selectiverenderer.authoring.packaging.PackagedFile;
import org.selectiverenderer.authoring.packaging.ScenePackage;
import org.selectiverenderer.authoring.packaging.ScenePackager;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.url.ContentAccessPolicy;

/**
 * Copies a scene with all files that it names, and the practice scene beside it, into the folder of
 * a study, so that the study moves to another machine as a whole.
 */
record SceneCopy(Path scene, Path folder) {
  private static final String PRACTICE = "practice.x3d";

  /**
   * Writes the copies.
   *
   * @param problems receives what is left out
   * @return the copy of the scene
   * @throws IOException if a file cannot be read or written, with a one-line message
   */
  Path write(ProblemCollector problems) throws IOException {
    Path source = scene.toRealPath();
    Path copy = folder.resolve(Objects.requireNonNull(scene.getFileName()));
    write(source, copy, problems);
    Path practice = source.resolveSibling(PRACTICE);
    if (Files.exists(practice) && !practice.equals(source)) {
      write(practice, folder.resolve(PRACTICE), problems);
    }
    return copy;
  }

  private void write(Path source, Path copy, ProblemCollector problems) throws IOException {
    Path around = Objects.requireNonNull(source.toRealPath().getParent());
    ScenePackage all =
        new ScenePackager(
                NodeCatalogue.load(),
                around,
                ContentAccessPolicy.none(),
                PackageLayout.around(around),
                () -> false)
            .collect(
                source, DocumentFile.open(source).document().snapshot(), folder.relativize(copy));
    all.left()
        .forEach(
            left ->
                problems.warning(
                    SourceLocation.of(left.file()),
                    "the url %s %s; the study does not have it"
                        .formatted(left.url(), left.reason())));
    List<PackagedFile> files = new ArrayList<>(all.files());
    files.add(all.scene());
    PackageWriter.intoFolder(files, folder, share -> {}).keep();
  }
}
