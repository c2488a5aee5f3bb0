package org.selectiverenderer.document.versions;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.selectiverenderer.document.Edit;
import org.selectiverenderer.document.EditRefused;
import org.selectiverenderer.document.SceneDocument;
import org.selectiverenderer.document.Snapshot;
import org.selectiverenderer.document.TextChange;
import org.selectiverenderer.polygon.simplify.Goal;
import org.selectiverenderer.polygon.versions.FileActions;
import org.selectiverenderer.polygon.versions.Version;
import org.selectiverenderer.polygon.versions.VersionMaker;
import org.selectiverenderer.polygon.versions.VersionPlan;
import org.selectiverenderer.polygon.versions.VersionPlan.PlannedFile;
import org.selectiverenderer.x3d.NodeCatalogue;
import org.selectiverenderer.x3d.Problems;

/**
 * Versions of one object of a document: planned beside the author's work, looked at, then applied.
 * Undoing takes the Switch out of the document again; the files of the versions stay, as nothing
 * refers to them then.
 */
public final class VersionsEdit {
  private final Snapshot snapshot;
  private final VersionPlan plan;

  private VersionsEdit(Snapshot snapshot, VersionPlan plan) {
    this.snapshot = snapshot;
    this.plan = plan;
  }

  /**
   * What is to be made.
   *
   * @param file of the document, against which urls count
   * @param object the DEF name of the object, or of the Transform or Group round it
   * @param goals of versions 2, 3 and so on
   * @param inlineFolder where the versions' files go, relative to the file's folder
   */
  public record Request(Path file, String object, List<Goal> goals, String inlineFolder) {
    public Request {
      goals = List.copyOf(goals);
    }
  }

  /**
   * Works out the versions; takes a while, so not for the thread of the window. Writes nothing.
   *
   * @return empty when the object cannot get versions, which is reported
   * @throws IOException if a file cannot be read, with one line that names it
   */
  public static Optional<VersionsEdit> plan(
      Snapshot snapshot, Request request, NodeCatalogue catalogue, Problems problems)
      throws IOException {
    VersionMaker.Request wanted =
        new VersionMaker.Request(
            request.file(),
            request.object(),
            request.goals(),
            request.file(),
            request.inlineFolder());
    return new VersionMaker(catalogue)
        .plan(wanted, snapshot.bytes(), problems)
        .map(plan -> new VersionsEdit(snapshot, plan));
  }

  /** The versions, the original first. */
  public List<Version> versions() {
    return plan.versions();
  }

  /** The versions' files with their content, for looking at them before they are written. */
  public List<PlannedFile> files() {
    return plan.files().stream().filter(file -> !file.file().equals(plan.scene())).toList();
  }

  /**
   * Writes the versions' files, all or none, and edits the document.
   *
   * @throws EditRefused if the document has changed since it was planned
   * @throws IOException if a file cannot be written; nothing has changed then
   */
  public void apply(SceneDocument document, FileActions actions) throws IOException {
    if (document.revision() != snapshot.revision()) {
      throw new EditRefused(
          "the scene has changed since the versions of '%s' were worked out; work them out again"
              .formatted(plan.object()));
    }
    plan.applyVersions(actions);
    List<TextChange> changes =
        plan.edits().stream()
            .map(edit -> new TextChange(edit.from(), edit.to(), edit.replacement()))
            .toList();
    document.perform(new Edit("Make versions of " + plan.object(), changes));
  }
}
