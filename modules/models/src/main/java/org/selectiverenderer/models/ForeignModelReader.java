package org.selectiverenderer.models;

import java.io.IOException;
import java.io.InputStream;
import java.util.Optional;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.models.importer.ImportedModel;
import org.selectiverenderer.models.importer.ModelFileSource;
import org.selectiverenderer.models.importer.ModelImportException;
import org.selectiverenderer.models.importer.ModelImportProcess;
import org.selectiverenderer.models.structure.ModelStructureCheck;
import org.selectiverenderer.models.structure.ModelStructureException;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.source.ReadLimits;
import org.selectiverenderer.x3d.url.UrlResolver;

/** Reads OBJ, PLY, STL, COLLADA and FBX files in a child process. */
final class ForeignModelReader {
  private final NodeCatalogue catalogue;
  private final Optional<UrlResolver> root;
  private final ModelImportProcess process;
  private final ModelStructureCheck structure;
  private final ProblemCollector problems;

  /**
   * @param root decides which files the model may refer to; empty if none
   */
  ForeignModelReader(
      NodeCatalogue catalogue,
      Optional<UrlResolver> root,
      ModelImportProcess process,
      ModelStructureCheck structure,
      ProblemCollector problems) {
    this.catalogue = catalogue;
    this.root = root;
    this.process = process;
    this.structure = structure;
    this.problems = problems;
  }

  /**
   * Reads a model.
   *
   * @return empty if the file is damaged, not of the format that its name says, or beyond a limit,
   *     which is reported as a problem
   * @throws IOException if it cannot be read
   */
  Optional<Model> read(ModelSource file) throws IOException {
    Optional<Model> model =
        imported(file, false).map(new ImportedModelConverter(file, catalogue, problems)::model);
    boolean damaged = model.isPresent() && model.get().polygons() == 0 && isDamaged(file);
    return damaged ? Optional.empty() : model;
  }

  /**
   * Returns the text of a scene of a model.
   *
   * @param limits the limits of the text
   * @param title the title of the scene
   * @param description a sentence that describes it
   * @return empty if the file is damaged or beyond a limit, which is reported as a problem
   * @throws IOException if it cannot be read, or the text would be longer than the limits allow
   */
  Optional<String> scene(ModelSource file, ReadLimits limits, String title, String description)
      throws IOException {
    Optional<ImportedModel> model = imported(file, true);
    if (model.isEmpty() || isWithoutFaces(model.get()) && isDamaged(file)) {
      return Optional.empty();
    }
    return Optional.of(
        new ImportedSceneWriter(model.get(), file, catalogue, limits, problems)
            .text(title, description));
  }

  private static boolean isWithoutFaces(ImportedModel model) {
    return model.meshes().stream().allMatch(ImportedPointWriter::isPoints);
  }

  private boolean isDamaged(ModelSource file) throws IOException {
    return new ModelFileDiagnostics(file, problems).reportMissingFaces();
  }

  private Optional<ImportedModel> imported(ModelSource file, boolean whole) throws IOException {
    process.start(); // it starts while the structure is checked
    try {
      return checked(file, whole);
    } catch (ModelStructureException | ModelImportException e) {
      problems.error(SourceLocation.of(file.name()), String.valueOf(e.getMessage()));
      return Optional.empty();
    }
  }

  private Optional<ImportedModel> checked(ModelSource file, boolean whole)
      throws IOException, ModelStructureException, ModelImportException {
    ModelFileSource.OpenFile content = file.content().open();
    try (InputStream in = content.content()) {
      structure.check(file.fileName(), in, content.size());
    }
    ModelFileAccess files = new ModelFileAccess(file, root);
    Optional<ImportedModel> imported =
        whole ? process.readScene(file.fileName(), files) : process.read(file.fileName(), files);
    if (imported.isPresent()) {
      files.report(Problem.Severity.WARNING, "what it defines is left out", problems);
    } else if (!files.report(Problem.Severity.ERROR, "nothing is read", problems)) {
      new ModelFileDiagnostics(file, problems).report();
    }
    return imported;
  }
}
