package org.selectiverenderer.doctor.run;

import java.io.IOException;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.FutureTask;
import java.util.concurrent.Semaphore;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.function.Consumer;
import org.selectiverenderer.doctor.Diagnosis;
import org.selectiverenderer.doctor.Probe;

/**
 * Runs the probes of a machine. As many run in parallel as there are processors; those that measure
 * run alone at the end.
 */
public final class Doctor {
  /** The time for a cancelled probe to end its process, in milliseconds. */
  private static final long LAST_ACTS_MS = 1000;

  private final ProbeProcess children;
  private final String home;

  /**
   * @param home the user's home folder, which reports replace by {@code ~}
   */
  public Doctor(ProbeProcess children, String home) {
    this.children = children;
    this.home = home;
  }

  /**
   * Runs all probes. No probe or child process is left behind, however this ends.
   *
   * @return their results, in the order of the probes
   * @throws InterruptedException if the waiting thread is interrupted
   */
  public List<Diagnosis> examine(List<Probe> probes) throws InterruptedException {
    Semaphore places = new Semaphore(Runtime.getRuntime().availableProcessors());
    List<FutureTask<List<Diagnosis>>> tasks =
        probes.stream().map(probe -> new FutureTask<>(() -> placed(probe, places))).toList();
    List<Thread> threads = new ArrayList<>();
    try {
      for (int index = 0; index < probes.size(); index++) {
        if (probes.get(index).place() != Probe.Place.ALONE) {
          threads.add(start("doctor-" + probes.get(index).name(), tasks.get(index)));
        }
      }
      return lines(probes, tasks);
    } finally {
      tasks.forEach(task -> task.cancel(true));
      for (Thread thread : threads) {
        thread.join(LAST_ACTS_MS);
      }
    }
  }

  /** Waits for the tasks; those that must run alone come last. */
  private List<Diagnosis> lines(List<Probe> probes, List<FutureTask<List<Diagnosis>>> tasks)
      throws InterruptedException {
    for (boolean alone : new boolean[] {false, true}) {
      for (int index = 0; index < probes.size(); index++) {
        if ((probes.get(index).place() == Probe.Place.ALONE) == alone) {
          if (alone) {
            tasks.get(index).run();
          }
          await(tasks.get(index));
        }
      }
    }
    List<Diagnosis> lines = new ArrayList<>();
    for (FutureTask<List<Diagnosis>> task : tasks) {
      await(task).forEach(line -> lines.add(line.without(home)));
    }
    return lines;
  }

  /**
   * Runs one probe on this thread. Any failure becomes a result, because a wrong version of a
   * library may throw anything.
   */
  public static void look(Probe probe, Consumer<Diagnosis> found) throws InterruptedException {
    try {
      probe.search().run(found);
    } catch (IOException | RuntimeException | LinkageError e) {
      String reason = e.getMessage() == null ? e.toString() : e.getMessage();
      found.accept(failed(probe, reason, ""));
    }
  }

  private List<Diagnosis> placed(Probe probe, Semaphore places) throws InterruptedException {
    places.acquire();
    try {
      return probe.place() == Probe.Place.HERE ? here(probe) : children.run(probe);
    } finally {
      places.release();
    }
  }

  /**
   * Runs a probe on a thread of its own, which is abandoned if it hangs, for example on a network
   * folder.
   */
  private static List<Diagnosis> here(Probe probe) throws InterruptedException {
    List<Diagnosis> lines = Collections.synchronizedList(new ArrayList<>());
    FutureTask<Void> task =
        new FutureTask<>(
            () -> {
              look(probe, lines::add);
              return null;
            });
    start("doctor-" + probe.name() + "-here", task);
    try {
      task.get(probe.limit().toMillis(), TimeUnit.MILLISECONDS);
    } catch (TimeoutException e) {
      lines.add(late(probe));
    } catch (ExecutionException e) {
      throw new IllegalStateException(e.getCause());
    }
    return List.copyOf(lines);
  }

  /** Returns the result of a probe that has timed out. */
  static Diagnosis late(Probe probe) {
    return failed(
        probe,
        "no answer in %d s".formatted(probe.limit().toSeconds()),
        "the library or device hangs, or the machine is very busy: try again under less load");
  }

  /** Returns the result of a probe that has failed. */
  static Diagnosis failed(Probe probe, String reason, String todo) {
    return new Diagnosis(Diagnosis.Status.MISSING, probe.subject(), reason, todo, probe.needed());
  }

  private static Thread start(String name, Runnable task) {
    Thread thread = new Thread(task, name);
    thread.setDaemon(true); // A hanging thread does not block the exit.
    thread.start();
    return thread;
  }

  private static List<Diagnosis> await(FutureTask<List<Diagnosis>> task)
      throws InterruptedException {
    try {
      return task.get();
    } catch (ExecutionException e) {
      if (e.getCause() instanceof InterruptedException interrupted) {
        throw interrupted; // The task ran on this thread.
      }
      throw new IllegalStateException(e.getCause()); // Failures of probes are results.
    }
  }
}
