package org.selectiverenderer.document.versions;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.selectiverenderer.base.files.FileTransaction;
import org.selectiverenderer.base.problem.Problems;
import org.selectiverenderer.document.Edit;
import org.selectiverenderer.document.EditRefused;
import org.selectiverenderer.document.SceneDocument;
import org.selectiverenderer.document.Snapshot;
import org.selectiverenderer.document.StepFile;
import org.selectiverenderer.polygon.model.ModelReader;
import org.selectiverenderer.polygon.simplify.Goal;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.files.ContentAccess;
import org.selectiverenderer.x3d.files.ContentBase;
import org.selectiverenderer.x3d.files.ContentRoot;
import org.selectiverenderer.x3d.read.FileLibraries;
import org.selectiverenderer.x3d.read.X3dReader;

/**
 * Versions of an object in a scene (thesis 4.2): in the object's place comes a Switch of Inlines,
 * each of which names a file with one version. The original becomes version 1 as it is; the others
 * are reduced. A Transform around the object stays where it was, and so does every other byte of
 * the scene. An object that has versions already gets new ones of its version 1.
 *
 * <p>Planned beside the author's work, looked at, then applied to the document or written with the
 * scene's file. Applied it is one step: undoing takes the Switch out of the document again, and the
 * files of the versions become what they were before. Versions that are there already may be kept
 * as they are, or be made anew under another name.
 */
public final class VersionsEdit {
  private final Snapshot snapshot;
  private final String object;
  private final List<ObjectVersion> versions;
  private final List<PlannedFile> files;
  private final PlannedFile scene;
  private final Edit edit;

  VersionsEdit(
      Snapshot snapshot,
      String object,
      List<ObjectVersion> versions,
      List<PlannedFile> files,
      PlannedFile scene,
      Edit edit) {
    this.snapshot = snapshot;
    this.object = object;
    this.versions = List.copyOf(versions);
    this.files = List.copyOf(files);
    this.scene = scene;
    this.edit = edit;
  }

  /**
   * What is to be made.
   *
   * @param scene the document's file, against which urls count
   * @param object the DEF name of the object, or of the Transform or Group round it
   * @param goals of versions 2, 3 and so on; a first one that is all of the original stands for
   *     version 1
   * @param output the changed scene's file; the scene's own to change it in place
   * @param access what the scene may name besides its own files
   * @param inlineFolder where the versions' files go, relative to the output's folder
   * @param kept the numbers of versions, from 2, whose files stay as they are; their goals do not
   *     count. Only an object that has these versions has such
   * @param name what the files that are made are named after; empty for the name of those that are
   *     there, else of the object
   */
  public record Request(
      Path scene,
      ContentAccess access,
      String object,
      List<Goal> goals,
      Path output,
      String inlineFolder,
      Set<Integer> kept,
      String name) {
    public Request {
      goals = List.copyOf(goals);
      kept = Set.copyOf(kept);
    }

    /** The same where no version is kept. */
    public Request(
        Path scene,
        ContentAccess access,
        String object,
        List<Goal> goals,
        Path output,
        String inlineFolder) {
      this(scene, access, object, goals, output, inlineFolder, Set.of(), "");
    }

    /** The same of a scene that may name no more than its own files. */
    public Request(Path scene, String object, List<Goal> goals, Path output, String inlineFolder) {
      this(scene, ContentAccess.none(), object, goals, output, inlineFolder);
    }

    /** The same, to change the scene in place. */
    public Request(Path scene, String object, List<Goal> goals, String inlineFolder) {
      this(scene, object, goals, scene, inlineFolder);
    }

    /** The same of a scene that may name more than its own files. */
    public Request allowing(ContentAccess more) {
      return new Request(scene, more, object, goals, output, inlineFolder, kept, name);
    }

    /** The same where some versions stay as they are. */
    public Request keeping(Set<Integer> numbers) {
      return new Request(scene, access, object, goals, output, inlineFolder, numbers, name);
    }

    /** The same with files named after something else. */
    public Request named(String other) {
      return new Request(scene, access, object, goals, output, inlineFolder, kept, other);
    }
  }

  /**
   * Works out the versions; takes a while, so not for the thread of a window. Writes nothing.
   *
   * @return empty when the object cannot get versions, which is reported
   * @throws BadSceneException if the scene's text cannot be changed without harm
   * @throws IOException if a file cannot be read, with one line that names it
   */
  public static Optional<VersionsEdit> plan(
      Snapshot snapshot, Request request, NodeCatalogue catalogue, Problems problems)
      throws IOException {
    Path folder = VersionFiles.folder(request.scene());
    X3dReader plain = new X3dReader(catalogue);
    ContentRoot root = new ContentRoot(folder, request.access());
    X3dReader reader = plain.with(new FileLibraries(plain, root), ContentBase.folder(folder));
    SceneSource scene = SceneSource.of(snapshot, reader, problems);
    Optional<ObjectElement> site = new SiteFinder(scene, problems).find(request.object());
    if (site.isEmpty()) {
      return Optional.empty();
    }
    ModelReader models = new ModelReader(catalogue, request.access());
    return new Planning(request, scene, site.get(), models, reader, problems).plan();
  }

  /**
   * The files of the versions that an object has, the original first; empty for an object without
   * versions, or one that cannot get any.
   *
   * @throws IOException if a file cannot be read, with one line that names it
   */
  public static List<Path> existing(Snapshot snapshot, Request request, NodeCatalogue catalogue)
      throws IOException {
    Path folder = VersionFiles.folder(request.scene());
    Problems unheard = new Problems(); // planning reports what is wrong
    SceneSource scene = SceneSource.of(snapshot, new X3dReader(catalogue), unheard);
    Optional<ObjectElement> site = new SiteFinder(scene, unheard).find(request.object());
    return site.filter(ObjectElement.Versioned.class::isInstance)
        .map(ObjectElement.Versioned.class::cast)
        .map(
            there ->
                new VersionFiles(scene, there, folder, request.inlineFolder(), "")
                    .of(there.inlines().size(), 1))
        .orElse(List.of());
  }

  /** Whether nothing would change: all versions stay as they are. */
  public boolean isEmpty() {
    return edit.isEmpty()
        && files.stream().allMatch(file -> file.state() == PlannedFile.State.UNCHANGED);
  }

  /** The DEF name of the object. */
  public String object() {
    return object;
  }

  /** The versions, the original first. */
  public List<ObjectVersion> versions() {
    return versions;
  }

  /** The versions' files with their content, for looking at them before they are written. */
  public List<PlannedFile> files() {
    return files;
  }

  /** The changed scene. */
  public PlannedFile scene() {
    return scene;
  }

  /** How the scene's text changes; empty when it already has the Switch. */
  public List<ShownChange> changes() {
    return ShownChange.of(edit, snapshot.text());
  }

  /**
   * Writes the versions' files, all or none, and edits the document, as one step. A file that is
   * replaced and was not made by this program is kept beside it besides.
   *
   * @throws EditRefused if the document has changed since it was planned
   * @throws IOException if a file cannot be written; nothing has changed then
   */
  public void apply(SceneDocument document) throws IOException {
    if (document.revision() != snapshot.revision()) {
      throw new EditRefused(
          ("the scene has changed since the versions of '%s' were computed; compute "
                  + "them again")
              .formatted(object));
    }
    document.perform(
        edit,
        files.stream()
            .filter(file -> file.state() != PlannedFile.State.UNCHANGED)
            .map(file -> new StepFile(file.file(), file.content(), file.byHand()))
            .toList());
  }

  /**
   * Writes the changed scene and the versions' files, those that change, or none.
   *
   * @return see {@link FileTransaction#commit}
   * @throws IOException if one cannot be written, with one line that names it
   */
  public List<Path> write() throws IOException {
    List<PlannedFile> all = new ArrayList<>(files);
    all.add(scene);
    return write(all);
  }

  private static List<Path> write(List<PlannedFile> files) throws IOException {
    FileTransaction writing = new FileTransaction();
    for (PlannedFile file : files) {
      if (file.state() != PlannedFile.State.UNCHANGED) {
        writing.add(file.file(), file.content());
      }
    }
    return writing.commit();
  }
}
