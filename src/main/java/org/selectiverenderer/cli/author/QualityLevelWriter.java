package org.selectiverenderer.cli.author;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.stream.Collectors;
import org.selectiverenderer.authoring.EditRejectedException;
import org.selectiverenderer.authoring.UndoableFileWrite;
import org.selectiverenderer.authoring.UndoableFileWrites;
import org.selectiverenderer.authoring.enrichment.DocumentEnrichment;
import org.selectiverenderer.authoring.enrichment.EnrichedSwitch;
import org.selectiverenderer.authoring.file.DocumentFile;
import org.selectiverenderer.authoring.qualities.QualityVersionsEdit;
import org.selectiverenderer.authoring.versions.ChangePreview;
import org.selectiverenderer.authoring.versions.PlannedFile;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.command.output.CommandException;
import org.selectiverenderer.command.output.Console;
import org.selectiverenderer.command.output.ExitStatus;
import org.selectiverenderer.schema.FieldQuality;
import org.selectiverenderer.swing.PictureReducer;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.url.ContentAccessPolicy;

/** Writes levels of texture and shading into a scene, with their pictures, and tells what. */
record QualityLevelWriter(Console console, boolean dry, Path scene, Path output) {
  ExitStatus write(
      DocumentFile file,
      QualityVersionsEdit.Request request,
      ContentAccessPolicy access,
      NodeCatalogue catalogue,
      ProblemCollector problems)
      throws IOException {
    if (!folder(output).equals(folder(scene))) {
      throw CommandException.usage(
          "--output must be in the folder of the scene, since levels name pictures relative to it");
    }
    Optional<QualityVersionsEdit.Plan> planned;
    try {
      planned =
          new QualityVersionsEdit(file.document(), catalogue, scene, output, access, problems)
              .plan(request, PictureReducer::reduced);
    } catch (EditRejectedException e) {
      console.message(e.getMessage());
      return ExitStatus.PROBLEMS;
    }
    if (planned.isEmpty()) {
      return ExitStatus.PROBLEMS;
    }
    QualityVersionsEdit.Plan plan = planned.get();
    if (request.schemas().isEmpty() && !hasSchemas(file, plan.object(), catalogue)) {
      console.message(
          ("%s: nothing chooses the levels of %s yet, since no version of it names a schema; name"
                  + " one for each level by --schemas, the best level's first")
              .formatted(output, plan.object()));
    }
    plan.qualities().forEach(quality -> print(plan.object(), quality));
    plan.files().forEach(this::print);
    if (dry) {
      console.line("would change  " + output);
      ChangePreview.of(plan.edit(), file.document().snapshot().text()).forEach(this::print);
      return ExitStatus.of(problems);
    }
    UndoableFileWrites.write(
        plan.files().stream()
            .filter(picture -> picture.state() != PlannedFile.State.UNCHANGED)
            .map(
                picture ->
                    new UndoableFileWrite(picture.file(), picture.content(), picture.byHand()))
            .toList(),
        () -> {});
    boolean changes = !plan.edit().isEmpty();
    file.document().perform(plan.edit());
    if (!output.equals(scene)) {
      file.saveAs(output);
    } else if (changes) {
      file.save();
    }
    console.line((changes ? "changed  " : "unchanged  ") + output);
    return ExitStatus.of(problems);
  }

  /** Returns whether versions of a Switch name schemas, which its levels follow. */
  private static boolean hasSchemas(DocumentFile file, String name, NodeCatalogue catalogue) {
    EnrichedSwitch node =
        new DocumentEnrichment(file.document(), catalogue).switchesByName().get(name);
    return node != null && node.values().stream().anyMatch(choice -> !choice.schemas().isEmpty());
  }

  private static Path folder(Path file) {
    return Objects.requireNonNull(file.toAbsolutePath().normalize().getParent());
  }

  private void print(String object, FieldQuality quality) {
    List<String> levels =
        quality.levels().stream().map(level -> String.join(" ", level.values())).toList();
    console.line(
        "%s  %s of %s: %s"
            .formatted(
                object,
                quality.quality().spelling(),
                quality.target(),
                levels.stream().collect(Collectors.joining(", "))));
  }

  private void print(PlannedFile file) {
    String done =
        switch (file.state()) {
          case NEW -> dry ? "would be created" : "new";
          case CHANGED -> dry ? "would change" : "changed";
          case UNCHANGED -> "unchanged";
        };
    Path here = Path.of("").toAbsolutePath();
    Path shown = file.file().startsWith(here) ? here.relativize(file.file()) : file.file();
    console.line(done + "  " + shown);
  }

  private void print(ChangePreview edit) {
    console.line(scene + ":" + edit.line() + ":");
    List<String> before = edit.before().lines().toList();
    List<String> after = edit.after().lines().toList();
    VersionsCommand.shortened(before).forEach(line -> console.line("- " + line));
    VersionsCommand.shortened(after).forEach(line -> console.line("+ " + line));
  }
}
