package org.selectiverenderer.enricher.area;

import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;
import java.util.function.Predicate;
import org.selectiverenderer.authoring.area.AreaBox;
import org.selectiverenderer.enricher.menu.NodeCommand;
import org.selectiverenderer.enricher.session.EnricherSession;
import org.selectiverenderer.enricher.text.Texts;
import org.selectiverenderer.geometry.BoundingBox;
import org.selectiverenderer.x3d.source.DocumentElement;

/** The commands that create areas and Switches, for menus, keys and views. */
public final class AreaCommands {
  /** Elements that no area is put around: other areas, and the scene as a whole. */
  private static final Set<String> NO_OBJECTS = Set.of("ProximitySensor", "X3D", "Scene");

  private final EnricherSession session;
  private final AsyncSceneQueries probe;
  private final NamePrompt question;
  private final NodeCommands nodes;

  /**
   * @param probe answers queries of the running scene
   * @param question asks for names
   */
  public AreaCommands(EnricherSession session, AsyncSceneQueries probe, NamePrompt question) {
    this.session = session;
    this.probe = probe;
    this.question = question;
    this.nodes = new NodeCommands(session);
  }

  public NodeCommands nodes() {
    return nodes;
  }

  public AsyncSceneQueries probe() {
    return probe;
  }

  private Optional<DocumentElement> selected() {
    return session.selection().filter(DocumentElement::attached);
  }

  /**
   * Adds an area around all selected nodes; around the room in which the preview's viewer is when
   * nothing, or only areas or the whole scene are selected.
   */
  public void addAroundSelection() {
    List<DocumentElement> around =
        session.selectedElements().stream()
            .filter(element -> element.attached() && !NO_OBJECTS.contains(element.name()))
            .toList();
    Consumer<Optional<BoundingBox>> answer =
        bounds ->
            bounds.ifPresentOrElse(
                found -> add(AreaBox.of(found)),
                () -> session.message(Texts.of("area.add.nothing")));
    if (around.isEmpty()) {
      probe.room(answer);
    } else {
      probe.around(around, answer);
    }
  }

  /**
   * Adds an area after asking for its name.
   *
   * @return whether the area was added
   */
  public boolean add(AreaBox box) {
    return question
        .ask(Texts.of("area.add.title"), nodes.free("Area"), nodes::complaint)
        .map(name -> nodes.add(name, box, this))
        .orElse(false);
  }

  /** Wraps the selected node in a Switch, after asking for its name. */
  public void makeSwitch() {
    Optional<DocumentElement> node = selected();
    if (node.isEmpty()) {
      session.message(Texts.of("area.switch.nothing"));
      return;
    }
    if (!session.attempt(() -> nodes.switches().check(node.get()))) {
      return;
    }
    question
        .ask(
            Texts.of("area.switch.title"),
            nodes.switches().proposedName(node.get()),
            nodes::complaint)
        .ifPresent(name -> nodes.wrap(node.get(), name, this));
  }

  /** Asks for another name of the selected node. */
  public void rename() {
    withNamed(node -> nodes.rename(node, question));
  }

  private void withNamed(Consumer<DocumentElement> work) {
    withSelected(
        node -> {
          if (nodes.named(node)) {
            work.accept(node);
          } else {
            session.message(Texts.of("area.noname", node));
          }
        });
  }

  /**
   * Returns the commands for the context menu of the selected node.
   *
   * @param before commits what is being typed elsewhere, so that the commands see it
   */
  public List<NodeCommand> commands(Runnable before) {
    Predicate<DocumentElement> free = element -> session.document().locked().isEmpty();
    Predicate<DocumentElement> named = free.and(nodes::named);
    Predicate<DocumentElement> wrapped = free.and(nodes.switches()::wraps);
    return List.of(
        command("renameNode", "rename.node", "F2", named, before, this::rename),
        command("makeSwitch", "switch", "ctrl shift W", wrapped, before, this::makeSwitch),
        command("addArea", "add", "ctrl shift A", free, before, this::addAroundSelection));
  }

  private static NodeCommand command(
      String id,
      String text,
      String key,
      Predicate<DocumentElement> fits,
      Runnable before,
      Runnable work) {
    return new NodeCommand(
        id,
        Texts.of("area." + text),
        key,
        fits,
        element -> {
          before.run();
          work.run();
        });
  }

  private void withSelected(Consumer<DocumentElement> work) {
    selected().ifPresentOrElse(work, () -> session.message(Texts.of("area.nothing")));
  }
}
