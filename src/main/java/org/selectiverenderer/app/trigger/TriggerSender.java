package org.selectiverenderer.app.trigger;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import java.util.function.UnaryOperator;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.decimal.DecimalRounding;
import org.selectiverenderer.study.definition.SessionFlag;
import org.selectiverenderer.study.definition.TriggerSettings;
import org.selectiverenderer.study.definition.TriggerSettings.Code;
import org.selectiverenderer.study.definition.TriggerSettings.Line;
import org.selectiverenderer.study.definition.TriggerSettings.Signal;
import org.selectiverenderer.study.session.SessionJournal;

/**
 * Sends a study's trigger signals. Signals are queued without blocking and sent by the thread
 * {@code triggers} in their order; each is logged in the journal with the time at which it was sent
 * and how long after its event that was. A signal that lasts is ended in time, or before the next
 * one. What cannot be sent is flagged once for each step, and the port is opened again for the next
 * signal.
 */
public final class TriggerSender implements AutoCloseable {
  private static final TriggerSettings NONE = new TriggerSettings("", 0, Map.of());
  private static final int MOST_WAITING = 1000;
  private static final double MILLI = 1e-6;

  /** A signal with its event. */
  private record Item(long nanos, String event, String step, Signal signal, String code) {}

  /** Ends the thread. */
  private static final Item END = new Item(0, "", "", new Code("1", 0), "");

  private final TriggerSettings settings;
  private final TriggerOutput.Opener opener;
  private final BlockingQueue<Item> queue = new LinkedBlockingQueue<>(MOST_WAITING);
  private final Thread thread = new Thread(this::work, "triggers");
  private @Nullable TriggerOutput output;
  private volatile @Nullable SessionJournal journal;
  private volatile Consumer<String> problem = text -> {};
  private String failedStep = "";
  private boolean failed;

  /** The signal that lasts, and until when. */
  private @Nullable Signal lasting;

  private long until;

  private TriggerSender(TriggerSettings settings, TriggerOutput.Opener opener) {
    this.settings = settings;
    this.opener = opener;
    thread.setDaemon(true);
    thread.setPriority(Thread.MAX_PRIORITY);
  }

  /**
   * Opens the port of a study, before its session begins.
   *
   * @param settings empty for a study without triggers, for which nothing is opened or sent
   * @throws IOException with one line, if it cannot be opened
   */
  public static TriggerSender of(Optional<TriggerSettings> settings) throws IOException {
    return settings.isEmpty()
        ? new TriggerSender(NONE, () -> TriggerOutput.serial("", 0))
        : open(
            settings.get(),
            () -> TriggerOutput.serial(settings.get().port(), settings.get().speed()));
  }

  /** As {@link #open(TriggerSettings)}, to an output of its own. */
  static TriggerSender open(TriggerSettings settings, TriggerOutput.Opener opener)
      throws IOException {
    TriggerSender sender = new TriggerSender(settings, opener);
    sender.output = opener.open();
    sender.thread.start();
    return sender;
  }

  /**
   * Sends the signals of a session from now on. Events of its journal come by {@link #event}.
   *
   * @param told receives messages for the experimenter
   * @return this, which is closed before the session is
   */
  public TriggerSender follow(SessionJournal opened, Consumer<String> told) {
    problem = told;
    journal = opened;
    opened.listenToSignals(this::signal);
    return this;
  }

  /** Sends the signal of a journal's event, if it has one; may be called on any thread. */
  public void event(JsonNode line) {
    signal(line.path("event").asText(), line.path("step").asText(), text -> filled(text, line));
  }

  private static String filled(String text, JsonNode line) {
    String filled = text;
    for (String members : new String[] {"levels", "stimulus"}) {
      for (Map.Entry<String, JsonNode> cell : line.path(members).properties()) {
        filled = filled.replace("{" + cell.getKey() + "}", cell.getValue().asText());
      }
    }
    return filled;
  }

  /** Sends the signal of a moment, if it has one; may be called on any thread. */
  void signal(String event, String step, UnaryOperator<String> fill) {
    Signal signal = settings.events().get(event);
    if (signal == null) {
      return;
    }
    long now = System.nanoTime();
    String code = signal instanceof Code one ? fill.apply(one.code()) : "";
    if (!queue.offer(new Item(now, event, step, signal, code))) {
      tellFailed(step, "the port is too slow; the signal of " + event + " was not sent");
    }
  }

  private void work() {
    try {
      while (true) {
        Item item = next();
        if (item == END) {
          break;
        }
        if (item != null) {
          send(item);
        }
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
    rest();
    close(output);
  }

  /** Returns the next signal; null when the present one has ended. */
  private @Nullable Item next() throws InterruptedException {
    if (lasting == null) {
      return queue.take();
    }
    Item item = queue.poll(Math.max(0, until - System.nanoTime()), TimeUnit.NANOSECONDS);
    if (item == null) {
      rest();
    }
    return item;
  }

  private void send(Item item) {
    rest();
    int code = 0;
    if (!(item.signal() instanceof Line)) {
      try {
        code = code(item);
      } catch (IOException e) {
        // The port is all right, and stays open.
        tellFailed(item.step(), unsent(item.event(), e));
        return;
      }
    }
    try {
      TriggerOutput port = output;
      if (port == null) {
        port = opener.open();
        output = port;
      }
      if (item.signal() instanceof Line line) {
        port.line(line.wire(), true);
      } else {
        port.send(code);
      }
      long sent = System.nanoTime();
      if (item.signal().ms() > 0) {
        lasting = item.signal();
        until = sent + Math.round(item.signal().ms() / MILLI);
      }
      told(item, sent);
    } catch (IOException e) {
      failed(item.step(), item.event(), e);
    }
  }

  private static int code(Item item) throws IOException {
    try {
      int code = Integer.parseInt(item.code());
      if (code >= 1 && code <= 255) {
        return code;
      }
    } catch (NumberFormatException e) {
      // The message below is for both.
    }
    throw new IOException("'%s' is no byte from 1 to 255".formatted(item.code()));
  }

  /** Ends the signal that lasts. */
  private void rest() {
    Signal ended = lasting;
    lasting = null;
    TriggerOutput port = output;
    if (ended == null || port == null) {
      return;
    }
    try {
      if (ended instanceof Line line) {
        port.line(line.wire(), false);
      } else {
        port.send(0);
      }
    } catch (IOException e) {
      failed("", "the end of a signal", e);
    }
  }

  private void told(Item item, long sent) {
    SessionJournal log = journal;
    if (log == null) {
      return;
    }
    Map<String, Object> members = new LinkedHashMap<>();
    if (!item.step().isEmpty()) {
      members.put("step", item.step());
    }
    members.put("at", item.event());
    if (item.signal() instanceof Line line) {
      members.put("line", line.wire().spelling());
    } else {
      members.put("byte", Integer.parseInt(item.code()));
    }
    members.put("sent_mono", DecimalRounding.to(6, sent * 1e-9));
    members.put("latency_ms", DecimalRounding.to(3, (sent - item.nanos()) * MILLI));
    log.tell("trigger", members);
  }

  private void failed(String step, String event, IOException reason) {
    close(output);
    output = null;
    lasting = null;
    tellFailed(step, unsent(event, reason));
  }

  private static String unsent(String event, IOException reason) {
    return "the trigger of %s was not sent: %s".formatted(event, reason.getMessage());
  }

  private synchronized void tellFailed(String step, String text) {
    if (failed && failedStep.equals(step)) {
      return; // Once for each step is enough to leave a session out.
    }
    failed = true;
    failedStep = step;
    SessionJournal log = journal;
    if (log != null) {
      Map<String, Object> members = new LinkedHashMap<>();
      if (!step.isEmpty()) {
        members.put("step", step);
      }
      members.put("text", text);
      log.flag(SessionFlag.TRIGGER_FAILED, members);
    }
    problem.accept(text);
  }

  private static void close(@Nullable TriggerOutput port) {
    if (port != null) {
      port.close();
    }
  }

  /** Sends the queued signals, ends the last one and closes the port. */
  @Override
  public void close() {
    boolean interrupted = false;
    while (thread.isAlive()) {
      try {
        queue.put(END);
        thread.join();
      } catch (InterruptedException e) {
        interrupted = true; // What is queued is sent first.
      }
    }
    if (interrupted) {
      Thread.currentThread().interrupt();
    }
  }
}
