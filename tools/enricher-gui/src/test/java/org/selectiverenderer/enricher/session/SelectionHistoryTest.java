package org.selectiverenderer.enricher.session;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.datatransfer.Clipboard;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.authoring.UndoHistory;
import org.selectiverenderer.authoring.placement.GroupEdits;
import org.selectiverenderer.enricher.menu.StructureCommands;
import org.selectiverenderer.enricher.robot.TestSessions;
import org.selectiverenderer.x3d.source.DocumentElement;

/** What Undo and Redo select. */
class SelectionHistoryTest {
  private static final String NODES =
      "<Group DEF='A'/><Group><Shape/></Group><Group DEF='B'/><Group DEF='C'/>";

  @TempDir Path folder;

  private StructureCommands commands(EnricherSession session) {
    return new StructureCommands(session, new Clipboard("test"));
  }

  private static List<String> selected(EnricherSession session) {
    return session.selectedElements().stream()
        .map(each -> session.document().text(each.start(), each.tagEnd()))
        .toList();
  }

  private static DocumentElement named(EnricherSession session, String def) {
    return session.document().tree().orElseThrow().named(def).orElseThrow();
  }

  private static DocumentElement unnamed(EnricherSession session) {
    return named(session, "A").parent().orElseThrow().children().get(1);
  }

  @Test
  void undoOfADeleteSelectsTheRestoredNodesAndRedoWhatTheDeleteSelected() throws IOException {
    EnricherSession session = TestSessions.with(folder, NODES);
    UndoHistory history = session.document().history();
    session.selectAll(List.of(named(session, "B"), unnamed(session)), this);
    commands(session).delete();
    List<String> after = selected(session);
    assertThat(after).doesNotContain("<Group DEF='B'/>");
    history.undo();
    assertThat(selected(session)).containsExactly("<Group DEF='B'/>", "<Group>");
    assertThat(session.selectedElements()).allMatch(DocumentElement::attached);
    history.redo();
    assertThat(selected(session)).isEqualTo(after);
    history.undo();
    assertThat(selected(session)).containsExactly("<Group DEF='B'/>", "<Group>");
  }

  @Test
  void eachStepSelectsItsOwnNodes() throws IOException {
    EnricherSession session = TestSessions.with(folder, NODES);
    UndoHistory history = session.document().history();
    session.select(named(session, "A"), this);
    commands(session).cut();
    session.select(named(session, "C"), this);
    commands(session).delete();
    session.select(named(session, "B"), this);
    history.undo();
    assertThat(selected(session)).containsExactly("<Group DEF='C'/>");
    history.undo();
    assertThat(selected(session)).containsExactly("<Group DEF='A'/>");
    history.redo();
    history.redo();
    assertThat(session.document().text().toString()).doesNotContain("DEF='A'", "DEF='C'");
  }

  @Test
  void undoOfGroupAndUngroupSelectsWhatTheyWereMadeOf() throws IOException {
    EnricherSession session = TestSessions.with(folder, NODES);
    UndoHistory history = session.document().history();
    GroupEdits groups = new GroupEdits(session.document(), session.catalogue());
    session.selectAll(List.of(named(session, "B"), named(session, "C")), this);
    session.perform(groups.group(session.selectedElements(), "G"));
    session.select(named(session, "G"), this);
    List<String> group = selected(session);
    assertThat(group).singleElement().asString().startsWith("<Transform");
    session.perform(groups.ungroup(named(session, "G")));
    session.selectAll(List.of(named(session, "B"), named(session, "C")), this);
    assertThat(selected(session)).containsExactly("<Group DEF='B'/>", "<Group DEF='C'/>");
    history.undo();
    assertThat(selected(session)).isEqualTo(group);
    history.undo();
    assertThat(selected(session)).containsExactly("<Group DEF='B'/>", "<Group DEF='C'/>");
    history.redo();
    assertThat(selected(session)).isEqualTo(group);
  }

  @Test
  void redoOfAPasteSelectsWhatWasPasted() throws IOException {
    EnricherSession session = TestSessions.with(folder, NODES);
    UndoHistory history = session.document().history();
    StructureCommands commands = commands(session);
    session.select(unnamed(session), this);
    commands.copy();
    session.select(named(session, "C"), this);
    commands.paste();
    int pasted = session.selection().orElseThrow().start();
    assertThat(selected(session)).containsExactly("<Group>");
    history.undo();
    assertThat(selected(session)).containsExactly("<Group DEF='C'/>");
    history.redo();
    assertThat(session.selection().orElseThrow().start()).isEqualTo(pasted);
  }

  @Test
  void undoOfTypingLeavesTheSelectionWhereItIs() throws IOException {
    EnricherSession session = TestSessions.with(folder, NODES);
    session.select(named(session, "A"), this);
    int at = named(session, "B").start();
    session.document().type(at, at, "<Group/>");
    session.select(named(session, "C"), this);
    session.document().history().undo();
    assertThat(selected(session)).containsExactly("<Group DEF='C'/>");
  }
}
