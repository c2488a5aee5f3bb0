package org.selectiverenderer.enricher.menu;

import static org.assertj.core.api.Assertions.assertThat;
import static org.selectiverenderer.enricher.Swing.edt;
import static org.selectiverenderer.enricher.Swing.get;

import java.awt.datatransfer.Clipboard;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import javax.swing.JMenuItem;
import javax.swing.JPopupMenu;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.enricher.driving.Sessions;
import org.selectiverenderer.enricher.session.EnricherSession;
import org.selectiverenderer.x3d.source.DocumentElement;

/** What can be done with the selected node. */
class NodeMenuTest {
  @TempDir Path folder;
  private EnricherSession session;
  private NodeMenu menu;

  private void open() throws IOException {
    session = Sessions.with(folder, "<Group DEF='A'/>\n<Group DEF='B'/>\n");
    menu = new NodeMenu(session);
    menu.add(NodeEditing.of(session, new Clipboard("test")));
  }

  private DocumentElement named(String def) {
    return session.document().tree().orElseThrow().named(def).orElseThrow();
  }

  private void choose(String def, String item) {
    edt(
        () -> {
          session.select(named(def), this);
          Stream.of(filled().getComponents())
              .filter(each -> item.equals(each.getName()))
              .map(JMenuItem.class::cast)
              .findFirst()
              .orElseThrow()
              .doClick();
        });
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
    assertThat(text()).contains("<Group DEF='B'/>\n<Group DEF='A'/>\n");
    choose("A", "copyNode");
    choose("A", "pasteNode");
    assertThat(text()).contains("<Group DEF='A'/>\n<Group DEF='A_2'/>\n");
    choose("B", "commentNode");
    assertThat(text()).contains("<!-- <Group DEF='B'/> -->");
    choose("A", "deleteNode");
    assertThat(text()).doesNotContain("DEF='A'/>");
    assertThat(get(() -> session.document().history().names()))
        .isEqualTo(List.of("Cut Group A", "Paste", "Paste", "Comment Group B", "Delete Group A"));
    for (int i = 0; i < 5; i++) {
      edt(() -> session.document().history().undo());
    }
    assertThat(text()).isEqualTo(before);
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

  private List<String> enabled() {
    return get(
        () ->
            Stream.of(filled().getComponents())
                .filter(each -> each.isEnabled() && each instanceof JMenuItem)
                .map(each -> each.getName())
                .toList());
  }
}
