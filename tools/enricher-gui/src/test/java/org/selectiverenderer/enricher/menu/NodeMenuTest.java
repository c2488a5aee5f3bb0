package org.selectiverenderer.enricher.menu;

import static org.assertj.core.api.Assertions.assertThat;
import static org.selectiverenderer.enricher.EventThread.edt;
import static org.selectiverenderer.enricher.EventThread.get;

import java.awt.datatransfer.Clipboard;
import java.awt.event.KeyEvent;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Stream;
import javax.swing.JMenuItem;
import javax.swing.JPopupMenu;
import javax.swing.KeyStroke;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.enricher.area.AreaCommands;
import org.selectiverenderer.enricher.area.AsyncSceneQueries;
import org.selectiverenderer.enricher.area.NamePrompt;
import org.selectiverenderer.enricher.robot.NoScene;
import org.selectiverenderer.enricher.robot.TestSessions;
import org.selectiverenderer.enricher.session.EnricherSession;
import org.selectiverenderer.x3d.source.DocumentElement;

/** What can be done with the selected node. */
class NodeMenuTest {
  @TempDir Path folder;
  private EnricherSession session;
  private NodeMenu menu;

  private void open() throws IOException {
    session = TestSessions.with(folder, "<Group DEF='A'/>\n<Group DEF='B'/>\n");
    menu = new NodeMenu(session);
    menu.add(NodeEditCommands.of(session, new StructureCommands(session, new Clipboard("test"))));
  }

  private DocumentElement named(String def) {
    return session.document().tree().orElseThrow().named(def).orElseThrow();
  }

  private void choose(String def, String item) {
    edt(
        () -> {
          session.select(named(def), this);
          item(item).doClick();
        });
  }

  /** Of the menu of what is selected now. */
  private JMenuItem item(String id) {
    return Stream.of(filled().getComponents())
        .filter(each -> id.equals(each.getName()))
        .map(JMenuItem.class::cast)
        .findFirst()
        .orElseThrow();
  }

  private JPopupMenu filled() {
    JPopupMenu popup = new JPopupMenu();
    menu.fill(popup);
    return popup;
  }

  private String text() {
    return get(() -> session.document().snapshot().text());
  }

  @Test
  void aNodeIsCutAndPastedCopiedCommentedAndDeleted() throws IOException {
    open();
    String before = text();
    choose("A", "cutNode");
    assertThat(text()).doesNotContain("'A'");
    choose("B", "pasteNode");
    assertThat(text()).contains("<Group DEF='B'>\n  <Group DEF='A'/>\n</Group>\n");
    choose("A", "copyNode");
    choose("A", "pasteNode");
    assertThat(text()).contains("  <Group DEF='A'/>\n  <Group DEF='A_2'/>\n");
    choose("A", "commentNode");
    assertThat(text()).contains("<!-- <Group DEF='A'/> -->");
    choose("A_2", "deleteNode");
    assertThat(text()).doesNotContain("DEF='A_2'/>");
    assertThat(get(() -> session.document().history().names()))
        .isEqualTo(List.of("Cut A", "Paste A", "Paste A", "Comment Group A", "Delete A_2"));
    for (int i = 0; i < 5; i++) {
      edt(() -> session.document().history().undo());
    }
    assertThat(text()).isEqualTo(before);
  }

  @Test
  void choicesMoveAndGoWithTheirMetadata() throws IOException {
    session =
        TestSessions.with(
            folder,
            """
            <Switch DEF='Switch_Cup' whichChoice='0'>
              <MetadataSet containerField='metadata' name='Cup'>
                <MetadataSet containerField='value' name='Cup_v1'>
                  <MetadataString containerField='value' name='consistencyType' value='"frame"'/>
                </MetadataSet>
              </MetadataSet>
              <Group DEF='One'/>
              <Group DEF='Two'/>
            </Switch>
            """);
    StructureCommands structure = new StructureCommands(session, new Clipboard("test"));
    edt(
        () -> {
          session.select(named("One"), this);
          structure.step(true);
        });
    assertThat(types()).containsExactly(Optional.empty(), Optional.of("frame"));
    assertThat(get(() -> session.selection().flatMap(DocumentElement::def))).contains("One");
    assertThat(text()).contains("whichChoice='1'");
    edt(
        () -> {
          session.select(named("Two"), this);
          structure.delete();
        });
    assertThat(types()).containsExactly(Optional.of("frame"));
    assertThat(text()).contains("whichChoice='0'");
  }

  private List<Optional<String>> types() {
    return get(
        () ->
            session.enrichment().switchNode(named("Switch_Cup")).orElseThrow().values().stream()
                .map(values -> values.type().map(type -> type.toString().toLowerCase(Locale.ROOT)))
                .toList());
  }

  @Test
  void whatDoesNotFitIsGreyedAndOthersAddTheirs() throws IOException {
    open();
    menu.add(new NodeCommand("mine", "Mine", node -> node.name().equals("Group"), node -> {}));
    edt(() -> session.select(session.document().tree().orElseThrow().root(), this));
    assertThat(enabled()).containsExactly("copyNode", "pasteNode");
    edt(() -> session.select(named("A"), this));
    assertThat(enabled()).hasSize(6).endsWith("mine");
    edt(() -> session.select(null, this));
    assertThat(get(() -> filled().getComponentCount())).isZero();
  }

  @Test
  void areasAndSwitchesAreThereWithTheLettersThatChooseThem() throws IOException {
    open();
    edt(
        () -> {
          AsyncSceneQueries probe = new NoScene();
          NamePrompt question = (title, proposal, complaint) -> Optional.of(proposal);
          menu.add(new AreaCommands(session, probe, question).commands(() -> {}));
        });
    String before = text();
    choose("A", "makeSwitch");
    assertThat(text()).contains("<Switch DEF='Switch_A' whichChoice='0'>");
    assertThat(get(() -> item("renameNode").getAccelerator()))
        .isEqualTo(KeyStroke.getKeyStroke("F2"));
    choose("B", "deleteNode");
    assertThat(text()).doesNotContain("DEF='B'/>");
    for (int i = 0; i < 2; i++) {
      edt(() -> session.document().history().undo());
    }
    assertThat(text()).isEqualTo(before);
    edt(() -> session.select(named("A"), this));
    JMenuItem rename = get(() -> item("renameNode"));
    assertThat(rename.getText()).isEqualTo("Rename Node...");
    assertThat(rename.getMnemonic()).isEqualTo(KeyEvent.VK_N);
    edt(() -> session.select(session.document().tree().orElseThrow().root(), this));
    assertThat(enabled()).containsExactly("copyNode", "pasteNode", "addArea");
  }

  @Test
  void anAreaForTheSceneAsAWholeStandsInTheRoom() throws IOException {
    open();
    NoScene probe = new NoScene();
    edt(
        () -> {
          NamePrompt question = (title, proposal, complaint) -> Optional.of(proposal);
          menu.add(new AreaCommands(session, probe, question).commands(() -> {}));
          session.select(session.document().tree().orElseThrow().scene().orElseThrow(), this);
          item("addArea").doClick();
        });
    assertThat(probe.asked()).containsExactly("room");
    choose("A", "addArea");
    edt(() -> session.selectAll(List.of(named("B"), named("A")), this));
    edt(() -> item("addArea").doClick());
    assertThat(probe.asked())
        .containsExactly("room", "around [Group A]", "around [Group B, Group A]");
  }

  private List<String> enabled() {
    return get(
        () ->
            Stream.of(filled().getComponents())
                .filter(each -> each.isEnabled() && each instanceof JMenuItem)
                .map(each -> each.getName())
                .toList());
  }
}
