package org.selectiverenderer.app.threshold;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import org.joml.Quaterniond;
import org.joml.Vector3d;
import org.selectiverenderer.authoring.DocumentSnapshot;
import org.selectiverenderer.authoring.file.DocumentFile;
import org.selectiverenderer.authoring.versions.ObjectVersion;
import org.selectiverenderer.authoring.versions.PlannedFile;
import org.selectiverenderer.authoring.versions.SceneNotEditableException;
import org.selectiverenderer.authoring.versions.VersionsEdit;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.browser.World;
import org.selectiverenderer.browser.instance.Background;
import org.selectiverenderer.browser.instance.ShapeInstance;
import org.selectiverenderer.browser.loading.SceneLoader;
import org.selectiverenderer.browser.nodes.NodeFactory;
import org.selectiverenderer.browser.viewer.Pose;
import org.selectiverenderer.geometry.BoundingBox;
import org.selectiverenderer.models.simplify.SimplificationTarget;
import org.selectiverenderer.render.AntiAliasing;
import org.selectiverenderer.render.preview.PreviewOptions;
import org.selectiverenderer.render.preview.ScenePreviewRenderer;
import org.selectiverenderer.study.threshold.StimulusLevels;
import org.selectiverenderer.study.threshold.ThresholdStudy;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.source.ReadLimits;

/**
 * Renders pictures of an object's versions: the object alone on grey, lit by a headlight, all from
 * the distance at which the original fills the picture. It is confined to the thread that opens it,
 * which owns its OpenGL context.
 */
final class StimulusRenderer implements AutoCloseable {
  private static final float GREY = 0.82f;
  private static final PreviewOptions ON_GREY =
      new PreviewOptions(
          List.of(),
          Set.of(),
          false,
          Optional.of(
              new Background(
                  new float[] {GREY, GREY, GREY}, new float[0], new float[0], new float[0], 0)));
  private static final double FIELD_OF_VIEW = Math.toRadians(30);
  private static final double ROOM = 1.05;

  private final ThresholdStudy study;
  private final NodeCatalogue catalogue = NodeCatalogue.load();
  private final ScenePreviewRenderer view = ScenePreviewRenderer.open();

  StimulusRenderer(ThresholdStudy study) {
    this.study = study;
  }

  /** Returns the file of a picture. */
  interface PictureFiles {
    Path file(int rung, int view);
  }

  /**
   * Makes the versions of an object, in memory, and takes a picture of each from each view.
   *
   * @return the polygon counts; empty when versions cannot be made, which is reported to {@code
   *     problems}
   */
  Optional<StimulusLevels> take(String object, PictureFiles files, ProblemCollector problems)
      throws IOException {
    Optional<VersionsEdit> plan = plan(object, problems);
    if (plan.isEmpty()) {
      return Optional.empty();
    }
    List<ObjectVersion> versions = rising(plan.get().versions());
    if (versions.size() < 3) {
      problems.error(
          SourceLocation.of(study.file().toString()),
          ("the object %s yields only %d versions that differ in polygons, but a pilot needs 3;"
                  + " remove the object, or give \"rungs\" a higher or \"fewest\" a lower value")
              .formatted(object, versions.size()));
      return Optional.empty();
    }
    BoundingBox box = BoundingBox.EMPTY;
    for (int rung = versions.size() - 1; rung >= 0; rung--) { // The original comes first.
      ObjectVersion version = versions.get(rung);
      Path folder = version.file().toAbsolutePath().getParent();
      try (SceneLoader loader =
          new SceneLoader(
              catalogue,
              new NodeFactory(),
              ReadLimits.standard(),
              study.access(),
              new ProblemCollector())) {
        byte[] content = content(plan.get(), version);
        World world =
            new World(
                loader.load(
                    version.file().toString(),
                    new ByteArrayInputStream(content),
                    folder == null ? Path.of("") : folder),
                new ProblemCollector());
        world.instances().update();
        box = rung == versions.size() - 1 ? bounds(world, object) : box;
        for (int i = 0; i < study.views().size(); i++) {
          Pose pose = pose(box, study.views().get(i));
          world.step(0, (viewer, now, dt) -> pose.applyTo(viewer));
          view.draw(world, ON_GREY, study.picture(), study.picture(), AntiAliasing.SMOOTH)
              .pixels()
              .writePng(files.file(rung, i));
        }
      }
    }
    return Optional.of(new StimulusLevels(versions.stream().map(ObjectVersion::polygons).toList()));
  }

  private Optional<VersionsEdit> plan(String object, ProblemCollector problems) throws IOException {
    DocumentSnapshot document = DocumentFile.open(study.scene()).document().snapshot();
    List<SimplificationTarget> goals =
        Arrays.stream(StimulusLevels.shares(study.fewest(), study.rungs()))
            .<SimplificationTarget>mapToObj(
                share -> new SimplificationTarget.VertexPercent(100 * share))
            .toList();
    ProblemCollector found = new ProblemCollector();
    try {
      Optional<VersionsEdit> plan =
          VersionsEdit.plan(
              document,
              new VersionsEdit.Request(study.scene(), object, goals, "inlineNodes")
                  .allowing(study.access()),
              catalogue,
              found);
      // Nothing is written, so warnings about files that would change are left out.
      found.list().stream()
          .filter(problem -> problem.severity() == Problem.Severity.ERROR)
          .forEach(problems::add);
      return plan;
    } catch (SceneNotEditableException e) {
      problems.error(SourceLocation.of(study.scene().toString()), String.valueOf(e.getMessage()));
      return Optional.empty();
    }
  }

  /** Returns the versions from the fewest polygons to the original, one for each polygon count. */
  private static List<ObjectVersion> rising(List<ObjectVersion> versions) {
    ObjectVersion original = versions.get(0);
    List<ObjectVersion> rising =
        new ArrayList<>(
            versions.stream()
                .skip(1)
                .filter(version -> version.polygons() < original.polygons())
                .collect(
                    Collectors.toMap(ObjectVersion::polygons, v -> v, (first, second) -> first))
                .values());
    rising.add(original);
    rising.sort(Comparator.comparing(ObjectVersion::polygons));
    return rising;
  }

  private static byte[] content(VersionsEdit plan, ObjectVersion version) throws IOException {
    for (PlannedFile file : plan.files()) {
      if (file.file().equals(version.file())) {
        return file.content();
      }
    }
    return Files.readAllBytes(version.file());
  }

  private BoundingBox bounds(World world, String object) throws IOException {
    return world.instances().shapes().stream()
        .filter(ShapeInstance::shown)
        .map(shape -> BoundingBox.of(shape.bounds()))
        .reduce(BoundingBox::union)
        .filter(box -> !box.isEmpty())
        .orElseThrow(
            () -> new IOException(study.scene() + ": the object " + object + " is not visible"));
  }

  /** Returns the camera pose at which a box fills the picture. */
  private static Pose pose(BoundingBox box, ThresholdStudy.View from) {
    Vector3d half = new Vector3d(box.max()).sub(box.min()).mul(0.5);
    Quaterniond orientation =
        new Quaterniond().rotationYXZ(Math.toRadians(from.yaw()), -Math.toRadians(from.pitch()), 0);
    Quaterniond toEye = orientation.conjugate(new Quaterniond());
    double slope = Math.tan(FIELD_OF_VIEW / 2);
    double distance = 0;
    for (int corner = 0; corner < 8; corner++) {
      Vector3d at =
          new Vector3d(
              (corner & 1) == 0 ? half.x : -half.x,
              (corner & 2) == 0 ? half.y : -half.y,
              (corner & 4) == 0 ? half.z : -half.z);
      toEye.transform(at);
      distance = Math.max(distance, at.z + Math.max(Math.abs(at.x), Math.abs(at.y)) / slope);
    }
    Vector3d back = orientation.transform(new Vector3d(0, 0, ROOM * distance));
    return new Pose(new Vector3d(box.min()).add(half).add(back), orientation, FIELD_OF_VIEW);
  }

  @Override
  public void close() {
    view.close();
  }
}
