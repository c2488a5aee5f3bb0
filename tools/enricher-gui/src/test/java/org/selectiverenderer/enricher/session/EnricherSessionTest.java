package org.selectiverenderer.enricher.session;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.authoring.EditRejectedException;
import org.selectiverenderer.enricher.robot.TestSessions;
import org.selectiverenderer.x3d.source.DocumentElement;

class EnricherSessionTest {
  @TempDir Path folder;

  @Test
  void theSelectionComesBackWhenABrokenTextIsMended() throws IOException {
    EnricherSession session = TestSessions.with(folder, TestSessions.object("Cup"));
    session.select(session.document().tree().orElseThrow().named("Switch_Cup").orElseThrow(), this);
    session.document().type(0, 0, "<");
    assertThat(session.selection()).isEmpty();
    session.document().history().undo();
    assertThat(session.selection()).hasValueSatisfying(e -> assertThat(e.attached()).isTrue());
    assertThat(session.selection().orElseThrow().def()).hasValue("Switch_Cup");
  }

  @Test
  void severalElementsStaySelectedWhenABrokenTextIsMended() throws IOException {
    EnricherSession session =
        TestSessions.with(folder, TestSessions.object("Cup") + TestSessions.object("Jug"));
    List<Optional<String>> heard = new ArrayList<>();
    session.addSelectionListener(
        (element, origin) -> heard.add(element.flatMap(DocumentElement::def)));
    session.selectAll(List.of(named(session, "Switch_Jug"), named(session, "Switch_Cup")), this);
    session.document().type(0, 0, "<");
    assertThat(session.selectedElements()).isEmpty();
    session.document().history().undo();
    assertThat(session.selectedElements())
        .containsExactly(named(session, "Switch_Jug"), named(session, "Switch_Cup"));
    assertThat(heard)
        .containsExactly(Optional.of("Switch_Cup"), Optional.empty(), Optional.of("Switch_Cup"));
  }

  @Test
  void aNodeIsFoundAgainInTheScopeOfItsName() throws IOException {
    EnricherSession session =
        TestSessions.with(
            folder,
            "<ProtoDeclare name='P'><ProtoBody><Group DEF='A'/><Group DEF='B'/></ProtoBody>"
                + "</ProtoDeclare><Group DEF='A'/>");
    String text = session.document().text().toString();
    for (int start : List.of(text.indexOf("<Group"), text.lastIndexOf("<Group"))) {
      session.select(session.document().tree().orElseThrow().at(start).orElseThrow(), this);
      session.document().type(0, 0, "<");
      session.document().history().undo();
      assertThat(session.selection().orElseThrow().start()).isEqualTo(start);
    }
  }

  private static DocumentElement named(EnricherSession session, String def) {
    return session.document().tree().orElseThrow().named(def).orElseThrow();
  }

  @Test
  void allViewsHearOfASelectionOnce() throws IOException {
    EnricherSession session = TestSessions.with(folder, TestSessions.object("Cup"));
    List<Object> heard = new ArrayList<>();
    session.addSelectionListener((element, origin) -> heard.add(origin));
    var element = session.document().tree().orElseThrow().root();
    session.select(element, "tree");
    session.select(element, "source");
    assertThat(heard).containsExactly("tree");
  }

  @Test
  void anEditThatIsRefusedIsToldAndNotMade() throws IOException {
    EnricherSession session = TestSessions.with(folder, TestSessions.object("Cup"));
    boolean made =
        session.attempt(
            () -> {
              throw new EditRejectedException("no");
            });
    assertThat(made).isFalse();
    assertThat(session.document().modified()).isFalse();
  }
}
