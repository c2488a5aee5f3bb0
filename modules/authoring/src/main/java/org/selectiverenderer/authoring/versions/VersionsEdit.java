package org.selectiverenderer.authoring.versions;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.Set;
import org.selectiverenderer.authoring.DocumentSnapshot;
import org.selectiverenderer.authoring.Edit;
import org.selectiverenderer.authoring.EditRejectedException;
import org.selectiverenderer.authoring.SceneDocument;
import org.selectiverenderer.authoring.UndoableFileWrite;
import org.selectiverenderer.base.files.FileTransaction;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.models.ModelReader;
import org.selectiverenderer.models.simplify.SimplificationTarget;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.read.PrototypeLibraryLoader;
import org.selectiverenderer.x3d.read.X3dReader;
import org.selectiverenderer.x3d.source.DocumentElement;
import org.selectiverenderer.x3d.url.BaseUrl;
import org.selectiverenderer.x3d.url.ContentAccessPolicy;
import org.selectiverenderer.x3d.url.UrlResolver;

/**
 * An edit that makes versions of an object in a scene (thesis 4.2): the object is replaced by a
 * Switch of Inlines, each of which loads a file with one version. The original becomes version 1
 * unchanged; the others are reduced. A Transform around the object and every other byte of the
 * scene stay unchanged. An object that has versions already gets new ones made from its version 1.
 *
 * <p>The edit is planned in the background, reviewed, and then applied to the document or written
 * with the scene's file. When applied it is one undo step: undoing removes the Switch from the
 * document and restores the files of the versions. Existing versions may be kept as they are, or be
 * made again under another name.
 */
public final class VersionsEdit {
  private final DocumentSnapshot snapshot;
  private final String object;
  private final List<ObjectVersion> versions;
  private final List<PlannedFile> files;
  private final PlannedFile scene;
  private final Edit edit;

  VersionsEdit(
      DocumentSnapshot snapshot,
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
   * The parameters of the versions.
   *
   * @param scene the document's file, against which URLs are resolved
   * @param object the DEF name of the object, or of the Transform or Group around it
   * @param goals the goals of versions 2, 3 and so on; a first goal equal to the whole original
   *     stands for version 1
   * @param output the changed scene's file; the scene's own to change it in place
   * @param access the files and URLs that the scene may load besides those in its folder
   * @param inlineFolder folder of the versions' files, relative to the output's folder
   * @param kept the numbers of existing versions, from 2, whose files are kept; their goals are
   *     ignored
   * @param name the base name of new files; empty for the name of the existing ones, else of the
   *     object
   * @param start the offset of the object's element, whose name is {@code object} whether or not it
   *     has a DEF; empty to find the element by its DEF
   */
  public record Request(
      Path scene,
      ContentAccessPolicy access,
      String object,
      List<SimplificationTarget> goals,
      Path output,
      String inlineFolder,
      Set<Integer> kept,
      String name,
      OptionalInt start) {
    public Request {
      goals = List.copyOf(goals);
      kept = Set.copyOf(kept);
    }

    /** Creates a request that keeps no version. */
    public Request(
        Path scene,
        ContentAccessPolicy access,
        String object,
        List<SimplificationTarget> goals,
        Path output,
        String inlineFolder) {
      this(scene, access, object, goals, output, inlineFolder, Set.of(), "", OptionalInt.empty());
    }

    /** Creates a request for a scene that may load only files in its own folder. */
    public Request(
        Path scene,
        String object,
        List<SimplificationTarget> goals,
        Path output,
        String inlineFolder) {
      this(scene, ContentAccessPolicy.none(), object, goals, output, inlineFolder);
    }

    /** Creates a request to change the scene in place. */
    public Request(
        Path scene, String object, List<SimplificationTarget> goals, String inlineFolder) {
      this(scene, object, goals, scene, inlineFolder);
    }

    /** Returns the request with another permission to load files and URLs. */
    public Request allowing(ContentAccessPolicy more) {
      return new Request(scene, more, object, goals, output, inlineFolder, kept, name, start);
    }

    /** Returns the request with versions to keep. */
    public Request keeping(Set<Integer> numbers) {
      return new Request(scene, access, object, goals, output, inlineFolder, numbers, name, start);
    }

    /** Returns the request for another object, of which no version is kept. */
    Request of(String other, List<SimplificationTarget> wanted) {
      return new Request(
          scene, access, other, wanted, output, inlineFolder, Set.of(), "", OptionalInt.empty());
    }

    /** Returns the request with another base name of files. */
    public Request named(String other) {
      return new Request(scene, access, object, goals, output, inlineFolder, kept, other, start);
    }

    /** Returns the request for the element at an offset, whose object need not have a DEF name. */
    public Request at(int offset) {
      return new Request(
          scene, access, object, goals, output, inlineFolder, kept, name, OptionalInt.of(offset));
    }

    /** Finds the object in its scene; empty after a problem has been reported. */
    Optional<ObjectElements> find(ElementNodeMapping in, ProblemCollector problems) {
      ObjectFinder finder = new ObjectFinder(in, problems);
      return start.isPresent()
          ? in.elements().at(start.getAsInt()).flatMap(element -> finder.at(element, object))
          : finder.find(object);
    }
  }

  /**
   * Plans the versions. This takes a while, so it must not run on the event dispatch thread. It
   * writes nothing.
   *
   * @return empty when versions cannot be made, which is reported
   * @throws SceneNotEditableException if the scene's text cannot be changed
   * @throws IOException if a file cannot be read, with a one-line message that names it
   */
  public static Optional<VersionsEdit> plan(
      DocumentSnapshot snapshot,
      Request request,
      NodeCatalogue catalogue,
      ProblemCollector problems)
      throws IOException {
    X3dReader reader = reader(request, catalogue);
    ElementNodeMapping scene = ElementNodeMapping.of(snapshot, reader, problems);
    Optional<ObjectElements> site = request.find(scene, problems);
    if (site.isEmpty()) {
      return Optional.empty();
    }
    ModelReader models = new ModelReader(catalogue, request.access());
    return new VersionsPlanner(request, scene, site.get(), models, reader, catalogue, problems)
        .plan();
  }

  private static X3dReader reader(Request request, NodeCatalogue catalogue) {
    Path folder = VersionFileNames.folder(request.scene());
    X3dReader plain = new X3dReader(catalogue);
    UrlResolver root = new UrlResolver(folder, request.access());
    return plain.with(new PrototypeLibraryLoader(plain, root), BaseUrl.folder(folder));
  }

  /** Reads the scene of a request with the libraries of its prototypes. */
  static ElementNodeMapping scene(
      DocumentSnapshot snapshot,
      Request request,
      NodeCatalogue catalogue,
      ProblemCollector problems)
      throws IOException {
    return ElementNodeMapping.of(snapshot, reader(request, catalogue), problems);
  }

  /**
   * Returns the files of an object's existing versions, the original first; empty for an object
   * without versions, or one that cannot have any.
   *
   * @throws IOException if a file cannot be read, with a one-line message that names it
   */
  public static List<Path> existing(
      DocumentSnapshot snapshot, Request request, NodeCatalogue catalogue) throws IOException {
    Path folder = VersionFileNames.folder(request.scene());
    ProblemCollector unheard = new ProblemCollector(); // planning reports what is wrong
    ElementNodeMapping scene = ElementNodeMapping.of(snapshot, new X3dReader(catalogue), unheard);
    Optional<ObjectElements> site = request.find(scene, unheard);
    return site.filter(ObjectElements.Versioned.class::isInstance)
        .map(ObjectElements.Versioned.class::cast)
        .map(
            there ->
                new VersionFileNames(scene, there, folder, request.inlineFolder(), "")
                    .of(there.inlines().size(), 1))
        .orElse(List.of());
  }

  /**
   * Returns a name for an object without a DEF, made from what its file says of it: a comment, the
   * name of its prototype, of its files or materials.
   *
   * @throws EditRejectedException if the text is not well-formed
   */
  public static String proposedName(SceneDocument document, DocumentElement element) {
    return document
        .tree()
        .map(tree -> new ObjectNamer(document.text(), tree).name(element))
        .orElseThrow(() -> new EditRejectedException("The text is not well formed"));
  }

  /** Returns whether nothing would change. */
  public boolean isEmpty() {
    return edit.isEmpty()
        && files.stream().allMatch(file -> file.state() == PlannedFile.State.UNCHANGED);
  }

  /** Returns the change of the scene's text. */
  Edit edit() {
    return edit;
  }

  /** Returns the DEF name of the object. */
  public String object() {
    return object;
  }

  /** Returns the versions, the original first. */
  public List<ObjectVersion> versions() {
    return versions;
  }

  /** Returns the versions' files with their content, for a preview. */
  public List<PlannedFile> files() {
    return files;
  }

  /** Returns the changed scene. */
  public PlannedFile scene() {
    return scene;
  }

  /** Returns the changes of the scene's text; empty when it already has the Switch. */
  public List<ChangePreview> changes() {
    return ChangePreview.of(edit, snapshot.text());
  }

  /**
   * Writes the versions' files, all or none, and edits the document, as one undo step. A replaced
   * file that was not generated by this program is backed up.
   *
   * @throws EditRejectedException if the document has changed since it was planned
   * @throws IOException if a file cannot be written; nothing has changed then
   */
  public void apply(SceneDocument document) throws IOException {
    apply(document, snapshot.revision(), edit, files, object);
  }

  /**
   * Writes files and edits a document as one step.
   *
   * @param revision the revision of the document that was planned on
   * @param object name of an object, for the message
   */
  static void apply(
      SceneDocument document, long revision, Edit edit, List<PlannedFile> files, String object)
      throws IOException {
    if (document.revision() != revision) {
      throw new EditRejectedException(
          ("the scene has changed since the versions of '%s' were computed; compute "
                  + "them again")
              .formatted(object));
    }
    document.perform(
        edit,
        files.stream()
            .filter(file -> file.state() != PlannedFile.State.UNCHANGED)
            .map(file -> new UndoableFileWrite(file.file(), file.content(), file.byHand()))
            .toList());
  }

  /**
   * Writes the changed ones of the scene and the versions' files, all or none.
   *
   * @return see {@link FileTransaction#commit}
   * @throws IOException if one cannot be written, with a one-line message that names it
   */
  public List<Path> write() throws IOException {
    List<PlannedFile> all = new ArrayList<>(files);
    all.add(scene);
    return write(all);
  }

  /** Writes those of the files that change, all or none. */
  static List<Path> write(List<PlannedFile> files) throws IOException {
    FileTransaction writing = new FileTransaction();
    for (PlannedFile file : files) {
      if (file.state() != PlannedFile.State.UNCHANGED) {
        writing.add(file.file(), file.content());
      }
    }
    return writing.commit();
  }
}
