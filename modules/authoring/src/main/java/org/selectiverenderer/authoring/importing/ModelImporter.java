package org.selectiverenderer.authoring.importing;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CancellationException;
import java.util.function.BooleanSupplier;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.selectiverenderer.authoring.DocumentSnapshot;
import org.selectiverenderer.authoring.SceneDocument;
import org.selectiverenderer.authoring.UndoableFileWrite;
import org.selectiverenderer.authoring.UniqueNameGenerator;
import org.selectiverenderer.authoring.file.XmlConversion;
import org.selectiverenderer.authoring.packaging.PackageLayout;
import org.selectiverenderer.authoring.packaging.PackagedFile;
import org.selectiverenderer.authoring.packaging.ScenePackage;
import org.selectiverenderer.authoring.packaging.ScenePackager;
import org.selectiverenderer.base.files.FileNameLength;
import org.selectiverenderer.base.files.InputFileReader;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.geometry.BoundingBox;
import org.selectiverenderer.models.Model;
import org.selectiverenderer.models.ModelReader;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.url.ContentAccessPolicy;
import org.selectiverenderer.x3d.url.UrlResolver;

/** Prepares models to be part of a scene. Reads and converts only; any thread may use it. */
public final class ModelImporter {
  /** The largest size of all files of a copy, as an undo step keeps them. */
  private static final long MOST_BYTES = 1L << 30;

  /** The bytes for what is added to the beginning of names, such as {@code _2-files}. */
  private static final int LONGEST_ENDING = 24;

  private final NodeCatalogue catalogue;
  private final Path folder;
  private final ContentAccessPolicy access;
  private final BooleanSupplier cancelled;

  /**
   * @param scene the file of the scene that a model is to be part of
   * @param access what that scene may read besides its own files
   * @param cancelled whether the work is to end
   */
  public ModelImporter(
      NodeCatalogue catalogue, Path scene, ContentAccessPolicy access, BooleanSupplier cancelled) {
    Path parent = scene.toAbsolutePath().normalize().getParent();
    this.catalogue = catalogue;
    this.folder = parent == null ? scene.toAbsolutePath() : parent;
    this.access = access;
    this.cancelled = cancelled;
  }

  /** Returns whether the scene may name a file, so that it can be linked. */
  public boolean mayLink(Path model) {
    return new UrlResolver(folder, access).mayBeNamed(model);
  }

  /**
   * Prepares a link: the model stays where it is.
   *
   * @throws IOException if it cannot be read, with a sentence
   */
  public ImportedModel link(Path model) throws IOException {
    InputFileReader.requireRegular(model);
    ProblemCollector problems = new ProblemCollector();
    Optional<BoundingBox> bounds = bounds(model, problems);
    if (problems.anyError()) {
      throw new IOException(first(model, problems));
    }
    return new ImportedModel(
        model.toAbsolutePath().normalize(), List.of(), bounds, problems.list());
  }

  /**
   * Prepares a copy in X3D XML beside the scene. What the model names comes along: its pictures
   * beside the copy, other files in a folder of their own. All get names that no file has.
   *
   * @throws IOException if it cannot be read or converted, with a sentence
   */
  public ImportedModel copy(Path model) throws IOException {
    InputFileReader.requireRegular(model);
    requireFew(model, Files.size(model));
    ProblemCollector problems = new ProblemCollector();
    String stem = freeStem(model);
    Path target = folder.resolve(stem + ".x3d");
    EmbeddedPictures pictures = new EmbeddedPictures(target);
    boolean converted = XmlConversion.of(model).isPresent();
    DocumentSnapshot text = text(model, problems);
    Path own = model.toAbsolutePath().getParent().toRealPath();
    ScenePackage packed =
        new ScenePackager(
                catalogue,
                own,
                access,
                PackageLayout.beside(own, folder.toRealPath(), Path.of(stem + "-files")),
                cancelled)
            .collect(model, text, Path.of(stem + ".x3d"));
    for (ScenePackage.LeftOut left : packed.left()) {
      problems.warning(
          SourceLocation.of(left.file()), "url '%s' %s".formatted(left.url(), left.reason()));
    }
    long size = Files.size(model);
    for (PackagedFile file : packed.files()) {
      size += file.size();
      requireFew(model, size); // before any of them is read
    }
    byte[] x3d = packed.scene().changed().orElseThrow();
    if (converted) {
      String taken = pictures.takenFrom(new String(x3d, StandardCharsets.UTF_8));
      x3d = taken.getBytes(StandardCharsets.UTF_8);
      pictures
          .faults()
          .forEach(fault -> problems.warning(SourceLocation.of(model.toString()), fault));
    }
    List<UndoableFileWrite> files = new ArrayList<>();
    files.add(new UndoableFileWrite(target, x3d, false));
    for (Map.Entry<Path, byte[]> picture : pictures.contents().entrySet()) {
      files.add(new UndoableFileWrite(picture.getKey(), picture.getValue(), false));
    }
    for (PackagedFile file : packed.files()) {
      if (cancelled.getAsBoolean()) {
        throw new CancellationException();
      }
      files.add(new UndoableFileWrite(folder.resolve(file.target()), bytes(file), false));
    }
    requireFew(model, files.stream().mapToLong(file -> file.content().length).sum());
    return new ImportedModel(target, files, bounds(model, new ProblemCollector()), problems.list());
  }

  private static void requireFew(Path model, long bytes) throws IOException {
    if (bytes > MOST_BYTES) {
      throw new IOException(
          model + ": with its files it has more than 1 GB; link to it instead of copying it");
    }
  }

  private static byte[] bytes(PackagedFile file) throws IOException {
    return file.changed().isPresent() ? file.changed().get() : InputFileReader.bytes(file.source());
  }

  private DocumentSnapshot text(Path model, ProblemCollector problems) throws IOException {
    Optional<XmlConversion> foreign = XmlConversion.of(model);
    byte[] bytes;
    if (foreign.isPresent()) {
      Optional<String> xml = foreign.get().xml(catalogue, problems);
      if (xml.isEmpty()) {
        throw new IOException(first(model, problems));
      }
      bytes = xml.get().getBytes(StandardCharsets.UTF_8);
    } else {
      bytes = InputFileReader.bytes(model);
    }
    SceneDocument document = SceneDocument.of(model.toString(), bytes);
    if (document.fault().isPresent()) {
      throw new IOException(
          document.fault().get().location() + ": " + document.fault().get().message());
    }
    if (document.tree().flatMap(tree -> tree.scene()).isEmpty()) {
      throw new IOException(model + ": this is neither a scene nor a model that can be read");
    }
    return document.snapshot();
  }

  private static String first(Path model, ProblemCollector problems) {
    return problems.list().stream()
        .filter(problem -> problem.severity() == Problem.Severity.ERROR)
        .findFirst()
        .map(Problem::toString)
        .orElse(model + ": nothing of it can be read");
  }

  private Optional<BoundingBox> bounds(Path model, ProblemCollector problems) throws IOException {
    try (ModelReader reader = new ModelReader(catalogue, access)) {
      ProblemCollector told = new ProblemCollector();
      Optional<BoundingBox> box = reader.read(model, told).flatMap(ModelImporter::box);
      told.list().forEach(problems::add);
      return box;
    }
  }

  private static Optional<BoundingBox> box(Model model) {
    double[] all = BoundingBox.EMPTY.toArray();
    model
        .meshes()
        .forEach(
            mesh -> {
              double[] own = BoundingBox.around(mesh.positions()).toArray();
              for (int i = 0; i < 3; i++) {
                all[i] = Math.min(all[i], own[i]);
                all[3 + i] = Math.max(all[3 + i], own[3 + i]);
              }
            });
    for (double side : all) {
      if (!Double.isFinite(side)) {
        return Optional.empty();
      }
    }
    return Optional.of(BoundingBox.of(all));
  }

  /** Returns the beginning of names for the copy and its files that no file of the folder has. */
  private String freeStem(Path model) throws IOException {
    String name = String.valueOf(model.getFileName());
    int dot = name.indexOf('.', 1);
    String wanted = UniqueNameGenerator.identifier(dot < 0 ? name : name.substring(0, dot));
    List<String> there;
    try (Stream<Path> all = Files.list(folder)) {
      there = all.map(path -> String.valueOf(path.getFileName())).toList();
    }
    wanted = FileNameLength.shortened(wanted, LONGEST_ENDING);
    String stem = wanted;
    for (int i = 2; taken(stem, there); i++) {
      stem = wanted + "_" + i;
    }
    return stem;
  }

  private static boolean taken(String stem, List<String> there) {
    Pattern own =
        Pattern.compile(
            Pattern.quote(stem) + "(\\.x3d|-files|-\\d+\\.\\w+)", Pattern.CASE_INSENSITIVE);
    return there.stream().anyMatch(name -> own.matcher(name).matches());
  }
}
