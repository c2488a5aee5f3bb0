# Ratings of two kinds of objects, analysed by R, without code of this program; see README.md.
# usage: Rscript ratings-golden.R FOLDER
suppressMessages(library(pROC))
folder <- commandArgs(trailingOnly = TRUE)[1]
set.seed(20240501)

# Cell probabilities: criteria c, absent N(0, 1), present N(a / b, 1 / b).
cells <- function(th, k, fixed) {
  a <- th[1]
  if (fixed) { b <- 1; c <- cumsum(c(th[2], exp(th[-(1:2)])))[seq_len(k - 1)] }
  else { b <- exp(th[2]); c <- cumsum(c(th[3], exp(th[-(1:3)])))[seq_len(k - 1)] }
  list(a = a, b = b, c = c, noise = diff(c(0, pnorm(c), 1)), signal = diff(c(0, pnorm(b * c - a), 1)))
}

fit <- function(noise, signal, fixed) {
  k <- length(noise)
  minus <- function(th) {
    p <- cells(th, k, fixed)
    l <- sum(ifelse(noise > 0, noise * log(pmax(p$noise, 1e-300)), 0)) +
      sum(ifelse(signal > 0, signal * log(pmax(p$signal, 1e-300)), 0))
    if (is.finite(l)) -l else 1e9
  }
  c0 <- qnorm(cumsum(noise + 1 / k)[-k] / (sum(noise) + 1))
  th <- c(1, if (!fixed) 0, c0[1], log(pmax(diff(c0), 0.05)))
  gradient <- function(th) sapply(seq_along(th), function(j) {
    e <- replace(numeric(length(th)), j, 1e-4)
    (8 * (minus(th + e) - minus(th - e)) - (minus(th + 2 * e) - minus(th - 2 * e))) / 12e-4
  })
  for (i in 1:4) {
    th <- optim(th, minus, method = "Nelder-Mead", control = list(reltol = 1e-14, maxit = 5000))$par
    best <- optim(th, minus, gradient, method = "BFGS", control = list(reltol = 1e-16, maxit = 2000))
    th <- best$par
  }
  p <- cells(best$par, k, fixed)
  list(p = p, loglik = -best$value)
}

# Expected information of (a, b, c...) by numerical derivatives of the cell probabilities.
information <- function(p, noise, signal, fixed) {
  k <- length(noise)
  th <- c(p$a, p$b, p$c)
  probs <- function(th) {
    c <- th[-(1:2)]
    c(diff(c(0, pnorm(c), 1)), diff(c(0, pnorm(th[2] * c - th[1]), 1)))
  }
  h <- 1e-5
  J <- sapply(seq_along(th), function(j) {
    e <- replace(numeric(length(th)), j, h)
    (8 * (probs(th + e) - probs(th - e)) - (probs(th + 2 * e) - probs(th - 2 * e))) / (12 * h)
  })
  w <- c(rep(sum(noise), k), rep(sum(signal), k)) / probs(th)
  I <- t(J) %*% (J * w)
  if (fixed) I <- I[-2, -2]
  solve(I)
}

sets <- list(
  # Pooled answers of a study with 18 participants.
  study = list(noise = c(30, 25, 20, 22, 11, 9, 12, 8, 6, 4), signal = c(12, 14, 11, 18, 9, 10, 16, 22, 25, 61)),
  three = list(noise = c(20, 10, 5), signal = c(6, 9, 30)),
  chance = list(noise = c(12, 9, 8, 11), signal = c(10, 11, 9, 10)),
  below = list(noise = c(5, 8, 20, 12), signal = c(15, 14, 9, 6)),
  unused = list(noise = c(20, 0, 10, 0, 5, 6), signal = c(6, 0, 9, 0, 12, 18)),
  holes = list(noise = c(20, 4, 10, 0, 5, 1), signal = c(3, 0, 9, 4, 12, 18))
)
for (i in 1:30) {
  k <- sample(4:10, 1)
  mu <- runif(1, -0.3, 2.2); sd <- runif(1, 0.6, 1.8)
  c <- sort(rnorm(k - 1, mu / 2, 1))
  n <- sample(60:400, 2)
  sets[[sprintf("random%02d", i)]] <- list(
    noise = tabulate(findInterval(rnorm(n[1]), c) + 1, k),
    signal = tabulate(findInterval(rnorm(n[2], mu, sd), c) + 1, k))
}

data <- NULL; golden <- NULL
put <- function(set, key, value) golden <<- rbind(golden, data.frame(set, key, value = sprintf("%.12g", value)))
for (name in names(sets)) {
  s <- sets[[name]]
  data <- rbind(data, data.frame(set = name, noise = paste(s$noise, collapse = " "), signal = paste(s$signal, collapse = " ")))
  used <- s$noise + s$signal > 0
  noise <- s$noise[used]; signal <- s$signal[used]; k <- length(noise)
  old <- rep(c(0, 1), c(sum(noise), sum(signal)))
  rating <- c(rep(seq_len(k), noise), rep(seq_len(k), signal))
  r <- roc(old, rating, direction = "<", quiet = TRUE)
  put(name, "auc", as.numeric(auc(r)))
  put(name, "auc_se", sqrt(var(r, method = "delong")))
  f <- fit(noise, signal, FALSE)
  v <- information(f$p, noise, signal, FALSE)
  a <- f$p$a; b <- f$p$b
  put(name, "a", a); put(name, "a_se", sqrt(v[1, 1]))
  put(name, "b", b); put(name, "b_se", sqrt(v[2, 2]))
  da <- a * sqrt(2 / (1 + b^2))
  g <- c(sqrt(2 / (1 + b^2)), -a * b * sqrt(2) / (1 + b^2)^1.5)
  put(name, "d_a", da); put(name, "d_a_se", sqrt(drop(g %*% v[1:2, 1:2] %*% g)))
  put(name, "a_z", pnorm(da / sqrt(2)))
  put(name, "a_z_se", dnorm(da / sqrt(2)) / sqrt(2) * sqrt(drop(g %*% v[1:2, 1:2] %*% g)))
  for (i in seq_len(k - 1)) {
    put(name, paste0("c", i), f$p$c[i]); put(name, paste0("c", i, "_se"), sqrt(v[2 + i, 2 + i]))
  }
  term <- function(x) sum(ifelse(x > 0, x * log(x / sum(x)), 0))
  full <- term(noise) + term(signal)
  g2 <- max(0, 2 * (full - f$loglik))
  put(name, "g2", if (k > 3) g2 else 0); put(name, "df", k - 3)
  if (k > 3) put(name, "g2_p", pchisq(g2, k - 3, lower.tail = FALSE))
  e <- fit(noise, signal, TRUE)
  ve <- information(e$p, noise, signal, TRUE)
  put(name, "equal_d", e$p$a); put(name, "equal_d_se", sqrt(ve[1, 1]))
  put(name, "equal_g2", 2 * (full - e$loglik))
  put(name, "slope_p", pchisq(max(0, 2 * (f$loglik - e$loglik)), 1, lower.tail = FALSE))
}
write.csv(data, file.path(folder, "ratings-data.csv"), row.names = FALSE, quote = FALSE)
write.csv(golden, file.path(folder, "ratings-golden.csv"), row.names = FALSE, quote = FALSE)
