package org.selectiverenderer.enricher.versions;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.selectiverenderer.authoring.DocumentSnapshot;
import org.selectiverenderer.authoring.versions.ObjectVersion;
import org.selectiverenderer.authoring.versions.PlannedFile;
import org.selectiverenderer.authoring.versions.VersionsEdit;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.models.ModelReader;
import org.selectiverenderer.models.simplify.SimplificationTarget;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.read.X3dFile;
import org.selectiverenderer.x3d.read.X3dReader;

/**
 * The result of computing versions, before anything is written.
 *
 * @param edit the edit that adds them; empty if that is impossible, as the problems say
 * @param shapes the meshes of the versions in order; empty for one that cannot be drawn
 * @param existing number of versions that the object has now, including the original; 0 for none
 */
record ComputedVersions(
    Optional<VersionsEdit> edit,
    List<Optional<ColoredMesh>> shapes,
    List<Problem> problems,
    int existing) {

  /**
   * Computes the initial result: as {@link #of}, but keeps versions that the object has already,
   * whatever the request asks for.
   */
  static ComputedVersions first(
      DocumentSnapshot snapshot, VersionsEdit.Request request, NodeCatalogue catalogue)
      throws IOException {
    int existing = VersionsEdit.existing(snapshot, request, catalogue).size();
    if (existing < 2) {
      return of(snapshot, request, catalogue);
    }
    VersionsEdit.Request keeping =
        new VersionsEdit.Request(
            request.scene(),
            request.access(),
            request.object(),
            Collections.nCopies(existing - 1, new SimplificationTarget.VertexPercent(100)),
            request.output(),
            request.inlineFolder(),
            IntStream.rangeClosed(2, existing).boxed().collect(Collectors.toSet()),
            request.name(),
            request.start());
    return of(snapshot, keeping, catalogue);
  }

  /** Computes the versions; slow, so not for the event dispatch thread. */
  static ComputedVersions of(
      DocumentSnapshot snapshot, VersionsEdit.Request request, NodeCatalogue catalogue)
      throws IOException {
    int existing = VersionsEdit.existing(snapshot, request, catalogue).size();
    ProblemCollector problems = new ProblemCollector();
    Optional<VersionsEdit> edit = VersionsEdit.plan(snapshot, request, catalogue, problems);
    List<Optional<ColoredMesh>> shapes = new ArrayList<>();
    if (edit.isPresent()) {
      for (ObjectVersion version : edit.get().versions()) {
        shapes.add(shape(version.file(), edit.get(), catalogue, request));
      }
    }
    return new ComputedVersions(edit, shapes, problems.list(), existing);
  }

  /**
   * Reads the mesh of a version: of a planned one from its content, of an existing one from its
   * file.
   */
  private static Optional<ColoredMesh> shape(
      Path file, VersionsEdit edit, NodeCatalogue catalogue, VersionsEdit.Request request)
      throws IOException {
    Optional<byte[]> planned =
        edit.files().stream()
            .filter(each -> each.file().equals(file))
            .map(PlannedFile::content)
            .findFirst();
    if (planned.isEmpty() && !Files.isReadable(file)) {
      return Optional.empty();
    }
    byte[] content = planned.isPresent() ? planned.get() : Files.readAllBytes(file);
    ProblemCollector unheard =
        new ProblemCollector(); // the plan has reported the object's problems
    X3dFile scene = new X3dReader(catalogue).read(file.toString(), content, unheard);
    Path folder = file.toAbsolutePath().getParent();
    return new ModelReader(catalogue, request.access())
        .ofSceneIn(request.scene().toAbsolutePath().resolveSibling(""))
        .of(
            scene.nodes(),
            scene,
            folder,
            SourceLocation.of(file.toString()),
            "the version",
            unheard)
        .map(ColoredMesh::of);
  }

  List<ObjectVersion> versions() {
    return edit.map(VersionsEdit::versions).orElse(List.of());
  }

  /** The number of vertices of the original: Max Vertex of thesis Fig 39; 0 if not known. */
  int maxVertex() {
    return versions().isEmpty() ? 0 : versions().get(0).vertices();
  }
}
