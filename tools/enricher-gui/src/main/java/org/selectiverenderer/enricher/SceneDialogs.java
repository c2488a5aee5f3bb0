package org.selectiverenderer.enricher;

import java.awt.Window;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;
import java.util.function.Supplier;
import java.util.stream.Collectors;
import org.selectiverenderer.base.decimal.DecimalFormatter;
import org.selectiverenderer.enricher.images.ImagesDialog;
import org.selectiverenderer.enricher.ratings.RatingsDialog;
import org.selectiverenderer.enricher.routes.RoutesDialog;
import org.selectiverenderer.enricher.session.EnricherSession;
import org.selectiverenderer.enricher.text.Texts;
import org.selectiverenderer.enricher.versions.BatchVersionsDialog;
import org.selectiverenderer.enricher.versions.VersionsDialog;
import org.selectiverenderer.x3d.source.DocumentElement;
import org.selectiverenderer.x3d.source.ElementTree;

/** The dialogs that edit the open scene. What is being typed is committed before they open. */
final class SceneDialogs {
  private final Window owner;
  private final Supplier<Optional<Workbench>> bench;
  private final Consumer<String> say;

  /**
   * @param bench the views of the open scene; empty for none
   * @param say shows a message in the status bar
   */
  SceneDialogs(Window owner, Supplier<Optional<Workbench>> bench, Consumer<String> say) {
    this.owner = owner;
    this.bench = bench;
    this.say = say;
  }

  /**
   * Imports expectancy ratings.
   *
   * @param table the CSV file to begin with; empty for none
   */
  void ratings(Optional<Path> table) {
    bench
        .get()
        .ifPresent(
            open -> {
              open.commit();
              RatingsDialog dialog = new RatingsDialog(owner, open.session());
              table.ifPresent(dialog::open);
              dialog.showAndWait();
            });
  }

  /** Opens the versions dialog for the object that the selection is or is part of. */
  void versions() {
    bench
        .get()
        .map(Workbench::session)
        .flatMap(EnricherSession::selection)
        .flatMap(SceneDialogs::object)
        .ifPresentOrElse(this::versions, () -> say.accept(Texts.of("window.chooseobject")));
  }

  /** Opens the dialog of the images that the scene names. */
  void images() {
    bench
        .get()
        .ifPresent(
            open -> {
              open.commit();
              new ImagesDialog(owner, open.session()).setVisible(true);
            });
  }

  /** Opens the dialog of the scene's ROUTEs. */
  void routes() {
    bench
        .get()
        .ifPresent(
            open -> {
              open.commit();
              new RoutesDialog(owner, open.session(), () -> open.showTab(2)).setVisible(true);
            });
  }

  /** Opens the dialog that makes versions of many objects. */
  void manyVersions() {
    bench
        .get()
        .ifPresent(
            open -> {
              open.commit();
              new BatchVersionsDialog(owner, open.session()).showAndWait();
              open.lookAtFilesAgain();
            });
  }

  /** Opens the versions dialog for an object. */
  void versions(DocumentElement object) {
    Optional<Workbench> open = bench.get();
    open.ifPresent(Workbench::commit);
    if (open.isPresent() && object.attached()) {
      EnricherSession session = open.get().session();
      Set<String> before = names(session);
      int made = new VersionsDialog(owner, session, object).made();
      open.get().lookAtFilesAgain();
      if (made > 0) {
        switches(session).stream()
            .filter(each -> each == object || !before.contains(each.def().orElse("")))
            .findFirst()
            .ifPresent(
                each -> {
                  session.select(each, this);
                  say.accept(
                      Texts.of(
                          "versions.made", each.toString(), made, DecimalFormatter.grouped(made)));
                });
      }
    }
  }

  private static List<DocumentElement> switches(EnricherSession session) {
    return session.document().tree().map(ElementTree::switches).orElse(List.of());
  }

  private static Set<String> names(EnricherSession session) {
    return switches(session).stream()
        .flatMap(each -> each.def().stream())
        .collect(Collectors.toSet());
  }

  /**
   * The object that versions can be made of: the nearest Switch around an element, else the element
   * itself if it has a DEF name, else the nearest one that is drawn by itself; one without a name
   * is given one.
   */
  static Optional<DocumentElement> object(DocumentElement element) {
    for (DocumentElement at = element; at != null; at = at.parent().orElse(null)) {
      if (at.name().equals("Switch")) {
        return Optional.of(at);
      }
    }
    if (element.def().isPresent()) {
      return Optional.of(element);
    }
    Optional<DocumentElement> at = Optional.of(element);
    while (at.isPresent() && !VersionsDialog.takes(at.get())) {
      at = at.get().parent();
    }
    return at;
  }
}
