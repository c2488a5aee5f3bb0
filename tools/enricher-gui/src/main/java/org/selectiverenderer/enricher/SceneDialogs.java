package org.selectiverenderer.enricher;

import java.awt.Window;
import java.nio.file.Path;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Supplier;
import org.selectiverenderer.enricher.ratings.RatingsDialog;
import org.selectiverenderer.enricher.session.EnricherSession;
import org.selectiverenderer.enricher.text.Texts;
import org.selectiverenderer.enricher.versions.VersionsDialog;
import org.selectiverenderer.x3d.source.DocumentElement;

/** The dialogs that change the open scene. They see what is typed so far. */
final class SceneDialogs {
  private final Window owner;
  private final Supplier<Optional<Workbench>> bench;
  private final Consumer<String> say;

  /**
   * @param bench of the open scene; empty for none
   * @param say shows a sentence
   */
  SceneDialogs(Window owner, Supplier<Optional<Workbench>> bench, Consumer<String> say) {
    this.owner = owner;
    this.bench = bench;
    this.say = say;
  }

  /**
   * Imports expectancy ratings.
   *
   * @param table to begin with; empty for none
   */
  void ratings(Optional<Path> table) {
    bench
        .get()
        .ifPresent(
            open -> {
              open.commit();
              RatingsDialog dialog = new RatingsDialog(owner, open.session());
              table.ifPresent(dialog::open);
              dialog.setVisible(true);
            });
  }

  /** Makes versions of the object that the selection is or is part of. */
  void versions() {
    bench
        .get()
        .map(Workbench::session)
        .flatMap(EnricherSession::selection)
        .flatMap(SceneDialogs::object)
        .ifPresentOrElse(this::versions, () -> say.accept(Texts.of("window.chooseobject")));
  }

  /** Makes versions of an object. */
  void versions(DocumentElement object) {
    Optional<Workbench> open = bench.get();
    open.ifPresent(Workbench::commit);
    if (open.isPresent() && object.attached()) {
      new VersionsDialog(owner, open.get().session(), object).setVisible(true);
      open.get().lookAtFilesAgain();
    }
  }

  /** The object that versions can be made of: the Switch around an element, or it itself. */
  static Optional<DocumentElement> object(DocumentElement element) {
    for (DocumentElement at = element; at != null; at = at.parent().orElse(null)) {
      if (at.name().equals("Switch")) {
        return Optional.of(at);
      }
    }
    return element.def().map(def -> element);
  }
}
