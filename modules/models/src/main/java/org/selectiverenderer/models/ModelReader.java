package org.selectiverenderer.models;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.atomic.AtomicBoolean;
import org.selectiverenderer.base.files.InputFileReader;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.models.importer.ImportLimits;
import org.selectiverenderer.models.importer.ModelImportProcess;
import org.selectiverenderer.models.structure.ModelStructureCheck;
import org.selectiverenderer.models.structure.ModelStructureException;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.catalogue.NodeView;
import org.selectiverenderer.x3d.read.NodeTraversal;
import org.selectiverenderer.x3d.read.PrototypeLibraryLoader;
import org.selectiverenderer.x3d.read.X3dFile;
import org.selectiverenderer.x3d.read.X3dReader;
import org.selectiverenderer.x3d.tessellate.Tessellator;
import org.selectiverenderer.x3d.url.BaseUrl;
import org.selectiverenderer.x3d.url.ContentAccessPolicy;
import org.selectiverenderer.x3d.url.UrlResolver;

/**
 * Reads models in X3D, glTF, OBJ, PLY, STL, COLLADA and FBX; file name extensions select the
 * format. Transformations are applied, so that all parts are in the file's own frame. Faces that
 * cannot be drawn are left out and reported. Thread-safe.
 *
 * <p>Files other than X3D and glTF are read in a child process, which is started with the first of
 * them and serves until the reader is closed, or this process ends.
 */
public final class ModelReader implements AutoCloseable {
  private static final Set<String> FOREIGN = Set.of("obj", "ply", "stl", "dae", "fbx");

  private static final Set<String> GLTF = Set.of("gltf", "glb");

  private final NodeCatalogue catalogue;
  private final X3dReader reader;
  private final ContentAccessPolicy access;
  private final Optional<Path> rootFolder;
  private final ImportLimits limits;
  private final ModelImportProcess importer;
  private final Tessellator tessellator = new Tessellator();

  public ModelReader(NodeCatalogue catalogue) {
    this(catalogue, ContentAccessPolicy.none());
  }

  /**
   * @param access further folders and hosts that models may refer to
   */
  public ModelReader(NodeCatalogue catalogue, ContentAccessPolicy access) {
    this(catalogue, access, Optional.empty(), ImportLimits.standard());
  }

  ModelReader(
      NodeCatalogue catalogue,
      ContentAccessPolicy access,
      Optional<Path> rootFolder,
      ImportLimits limits) {
    this.limits = limits;
    this.importer = new ModelImportProcess(limits);
    this.access = access;
    this.rootFolder = rootFolder;
    this.catalogue = catalogue;
    this.reader = new X3dReader(catalogue);
  }

  /**
   * Returns a reader for nodes of files that a scene in that folder inlines, which may refer to
   * whatever the scene may refer to.
   */
  public ModelReader ofSceneIn(Path folder) {
    return new ModelReader(catalogue, access, Optional.of(folder), limits);
  }

  /**
   * Reads a file.
   *
   * @return empty when it has no faces or is damaged, which is reported as a problem
   * @throws IOException if it cannot be read, with one line that names it
   */
  public Optional<Model> read(Path file, ProblemCollector problems) throws IOException {
    SourceLocation location = SourceLocation.of(file.toString());
    if (FOREIGN.contains(ending(file))) {
      check(file);
      return foreign(file, problems)
          .read(ModelSource.of(file))
          .flatMap(model -> withFaces(model, location, "the file", problems));
    }
    if (GLTF.contains(ending(file))) {
      check(file);
      try {
        new ModelStructureCheck(limits.maxModelBytes()).check(file);
      } catch (ModelStructureException e) {
        problems.error(location, String.valueOf(e.getMessage()));
        return Optional.empty();
      }
    }
    UrlResolver root = new UrlResolver(folder(file), access);
    ProblemCollector told = new ProblemCollector();
    X3dFile scene =
        reader
            .with(new PrototypeLibraryLoader(reader, root), BaseUrl.folder(folder(file)))
            .read(file, told);
    told.list().forEach(problems::add);
    if (GLTF.contains(ending(file)) && told.any() && !hasGeometry(scene)) {
      return Optional.empty(); // why has been said
    }
    return gathered(scene.nodes(), scene, folder(file), location, "the file", problems);
  }

  private static boolean hasGeometry(X3dFile scene) {
    AtomicBoolean found = new AtomicBoolean();
    NodeTraversal.visit(
        scene.nodes(),
        node -> {
          if (node.type().is("X3DGeometryNode")) {
            found.set(true);
          }
        });
    return found.get();
  }

  private ForeignModelReader foreign(Path file, ProblemCollector problems) {
    return new ForeignModelReader(
        catalogue,
        Optional.of(new UrlResolver(folder(file), access)),
        importer,
        new ModelStructureCheck(limits.maxModelBytes()),
        problems);
  }

  /** Ends the child process, if there is one. */
  @Override
  public void close() {
    importer.close();
  }

  /**
   * Returns the surfaces of some nodes of a scene, in the frame of their parent.
   *
   * @param folder folder of the scene's file
   * @param subject subject of the message if there are no faces, such as {@code the file}
   */
  public Optional<Model> of(
      List<? extends NodeView> nodes,
      X3dFile scene,
      Path folder,
      SourceLocation location,
      String subject,
      ProblemCollector problems) {
    return gathered(nodes, scene, folder, location, subject, problems);
  }

  private Optional<Model> gathered(
      List<? extends NodeView> nodes,
      X3dFile scene,
      Path folder,
      SourceLocation location,
      String subject,
      ProblemCollector problems) {
    UrlResolver root = new UrlResolver(rootFolder.orElse(folder).toAbsolutePath(), access);
    ModelPartCollector gatherer =
        new ModelPartCollector(reader, tessellator, root, limits.maxModelBytes(), problems);
    gatherer.gather(nodes, folder, ModelPartCollector.metres(scene));
    if (gatherer.beyond().isPresent()) {
      problems.error(
          location,
          "%s %s, which is the limit; it is not read".formatted(subject, gatherer.beyond().get()));
      return Optional.empty();
    }
    return withFaces(new Model(gatherer.parts(), scene.units()), location, subject, problems);
  }

  private static Optional<Model> withFaces(
      Model model, SourceLocation location, String subject, ProblemCollector problems) {
    if (model.polygons() == 0) {
      problems.error(location, subject + " has no faces, so there is nothing to reduce");
      return Optional.empty();
    }
    return Optional.of(model);
  }

  private static void check(Path file) throws IOException {
    if (!Files.exists(file)) {
      throw new NoSuchFileException(file.toString());
    }
    InputFileReader.requireRegular(file);
    if (!Files.isReadable(file)) {
      throw new IOException(file + ": no permission to read the file");
    }
  }

  private static String ending(Path file) {
    String name = String.valueOf(file.getFileName());
    return name.substring(name.lastIndexOf('.') + 1).toLowerCase(Locale.ROOT);
  }

  /** Returns the folder that contains a file. */
  static Path folder(Path file) {
    Path parent = file.toAbsolutePath().getParent();
    return parent == null ? file.toAbsolutePath() : parent;
  }
}
