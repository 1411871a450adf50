function w = scale_window (u, y)
  # u to 0 ... 1, y to zero mean and unit variance; h is 1 where u rises, equation (3),
  # by turning points: a new extreme, then a retreat of more than 30 % of the range; the
  # first counts only if u came to it from as far.
  w.u = (u - min (u)) / (max (u) - min (u));
  w.y = (y - mean (y)) / std (y, 1);

  threshold = 0.3;
  n = numel (u);
  w.h = zeros (n, 1);
  marked = 0;
  direction = 0;
  low_at = high_at = 1;
  for t = 1 : n
    now = w.u(t);
    if (now > w.u(high_at))
      high_at = t;
    end
    if (now < w.u(low_at))
      low_at = t;
    end
    if (direction >= 0 && w.u(high_at) - now > threshold)
      if (direction > 0)
        w.h(marked + 1 : high_at) = 1;
        marked = high_at;
      end
      direction = -1;
      low_at = t;
    elseif (direction <= 0 && now - w.u(low_at) > threshold)
      if (direction < 0)
        w.h(marked + 1 : low_at) = 0;
        marked = low_at;
      end
      direction = 1;
      high_at = t;
    end
  end
  w.h(marked + 1 : end) = direction > 0 || (direction == 0 && w.u(end) > w.u(1));
end
